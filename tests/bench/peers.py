#!/usr/bin/env python3
"""What a user would otherwise write: the same analyses with numpy, scipy, networkx and SymPy.

    peers.py FOLDER      FOLDER holds the trains that geargraph_bench_trains wrote

Prints one JSON object {name: seconds}, the best of a few runs each. All axes of these trains are parallel to z, so the
sign of a mesh is that of its kind.
"""

import json
import pathlib
import sys
import time

import networkx as nx
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as sparse_linalg
import sympy


class Train:
    """Links, joints and meshes by position, and each mesh's carrier side of every joint on its path."""

    def __init__(self, path):
        document = json.loads(pathlib.Path(path).read_text())
        number = {link["id"]: i for i, link in enumerate(document["links"])}
        self.n = len(number) - 1
        self.joints = [(number[j["tail"]], number[j["head"]], j["axis"]) for j in document["turningJoints"]]
        self.meshes = [
            (number[m["tail"]], number[m["head"]], m["tailTeeth"], m["headTeeth"],
             1 if m.get("kind") == "internal" else -1)
            for m in document["gearMeshes"]
        ]


def best(function, runs=3):
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def incidence(train):
    edges = train.joints + [(m[0], m[1], None) for m in train.meshes]
    columns = np.arange(len(edges))
    rows = np.concatenate([[e[0] for e in edges], [e[1] for e in edges]])
    values = np.concatenate([-np.ones(len(edges)), np.ones(len(edges))])
    return sparse.csc_matrix((values, (rows, np.concatenate([columns, columns]))), (train.n + 1, len(edges)))


def mesh_row(train, graph, mesh):
    """The row of P with whole numbers: teeth of the tail gear up to the carrier, then of the head gear."""
    tail, head, tail_teeth, head_teeth, sign = mesh
    path = nx.shortest_path(graph, tail, head)
    row = {}
    first_axis = None
    for a, b in zip(path, path[1:]):
        data = graph.edges[a, b]
        first_axis = first_axis or data["axis"]
        direction = 1 if data["tail"] == a else -1
        weight = tail_teeth if data["axis"] == first_axis else sign * head_teeth
        row[data["joint"]] = direction * weight
    return row


def networkx_scipy(train):
    """Digraph, Γ⁰, Z, C, and the speeds for the free joints; sparse, no rank."""
    graph = nx.Graph()
    for joint, (tail, head, axis) in enumerate(train.joints):
        graph.add_edge(tail, head, joint=joint, axis=axis, tail=tail)
    gamma = incidence(train)[1:]
    t = len(train.joints)
    g, g_star = gamma[:, :t].tocsc(), gamma[:, t:]
    z_columns = sparse_linalg.spsolve(g, sparse.identity(train.n, format="csc")) * -1
    tree_block = (g_star.T @ z_columns.T).tocsr()
    cycle_basis = sparse.hstack([tree_block, sparse.identity(len(train.meshes))])
    rows, columns, values = [], [], []
    for i, mesh in enumerate(train.meshes):
        for joint, value in mesh_row(train, graph, mesh).items():
            rows.append(i)
            columns.append(joint)
            values.append(value)
    p = sparse.csc_matrix((values, (rows, columns)), (len(train.meshes), t))
    inputs, outputs = split(train)
    return cycle_basis, sparse_linalg.spsolve(p[:, outputs], -p[:, inputs])


def split(train):
    """Inputs: the joints that these families leave undriven; found once, outside the clock."""
    return train.inputs, train.outputs


def numpy_dense(train):
    """The paper's formulas with dense matrices: Z = -G⁻¹, T = G*ᵀ Zᵀ, P = T ∘ p, θ̇ = -P_r⁻¹ P_E."""
    t = len(train.joints)
    gamma0 = np.zeros((train.n + 1, t + len(train.meshes)))
    for e, edge in enumerate(train.joints + train.meshes):
        gamma0[edge[0], e] = -1
        gamma0[edge[1], e] = 1
    gamma = gamma0[1:]
    g, g_star = gamma[:, :t], gamma[:, t:]
    z = -np.linalg.inv(g)
    tree_block = g_star.T @ z.T
    p = tree_block * train.dense_weights
    inputs, outputs = split(train)
    return np.linalg.solve(p[:, outputs], -p[:, inputs])


def prepare(train):
    """What both peers are given for free: the weights as arrays, and a valid split into inputs and outputs."""
    graph = nx.Graph()
    for joint, (tail, head, axis) in enumerate(train.joints):
        graph.add_edge(tail, head, joint=joint, axis=axis, tail=tail)
    t = len(train.joints)
    train.rows = [mesh_row(train, graph, mesh) for mesh in train.meshes]
    taken, outputs = set(), []
    for row in train.rows:  # the last joint of a cycle is what its mesh drives
        joint = max((j for j in row if j not in taken), default=None)
        if joint is not None:
            taken.add(joint)
            outputs.append(joint)
    train.outputs = sorted(outputs)
    train.inputs = [j for j in range(t) if j not in taken]
    if t <= 2000:
        train.dense_weights = np.zeros((len(train.meshes), t))
        for i, row in enumerate(train.rows):
            for joint, value in row.items():
                train.dense_weights[i, joint] = abs(value)
    return train


def sympy_matrix(train):
    """P with a ratio symbol per mesh, split into (P_r, P_E)."""
    t = len(train.joints)
    p = sympy.zeros(len(train.meshes), t)
    for i, (row, mesh) in enumerate(zip(train.rows, train.meshes)):
        ratio = sympy.Symbol(f"i{train.n + t + 1 + i}")
        for joint, value in row.items():
            on_tail_side = abs(value) == mesh[2] and (abs(value) != mesh[3] or value > 0)
            p[i, joint] = (1 if value > 0 else -1) * (ratio if on_tail_side else 1)
    return p[:, train.outputs], p[:, train.inputs]


def sympy_lusolve(train):
    outputs, inputs = sympy_matrix(train)
    return sympy.simplify(outputs.LUsolve(-inputs))


def sympy_linsolve(train):
    outputs, inputs = sympy_matrix(train)
    unknowns = sympy.symbols(f"q0:{outputs.shape[1]}")
    right = -inputs * sympy.ones(inputs.shape[1], 1)
    return sympy.linsolve((outputs, right), *unknowns)


def numpy_poses(train):
    """Forward kinematics down the tree: T_child = T_parent Exp(z, p, 0.25), a 4 x 4 product a link."""
    poses = [np.eye(4)] * (train.n + 1)
    cosine, sine = np.cos(0.25), np.sin(0.25)
    for joint, (tail, head, _) in enumerate(train.joints):  # parents stand before their children in these files
        x = float(joint)
        step = np.array([[cosine, -sine, 0, x - cosine * x], [sine, cosine, 0, -sine * x], [0, 0, 1, 0], [0, 0, 0, 1]])
        poses[head] = poses[tail] @ step
    return poses


def main():
    folder = pathlib.Path(sys.argv[1])
    result = {}
    for size in ("1000", "10000"):
        train = prepare(Train(folder / f"tree-{size}.geargraph"))
        result[f"networkx+scipy {size}"] = best(lambda: networkx_scipy(train), 3 if size == "1000" else 1)
        if size == "1000":
            result["numpy dense 1000"] = best(lambda: numpy_dense(train))
            result["numpy poses 1000"] = best(lambda: numpy_poses(train))
    seven = prepare(Train(folder / "tree-7.geargraph"))
    result["sympy LUsolve 7"] = best(lambda: sympy_lusolve(seven))
    twenty = prepare(Train(folder / "tree-20.geargraph"))
    result["sympy LUsolve 20"] = best(lambda: sympy_lusolve(twenty), 1)
    eighty = prepare(Train(folder / "tree-80.geargraph"))
    result["sympy linsolve 80"] = best(lambda: sympy_linsolve(eighty), 1)
    json.dump(result, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
