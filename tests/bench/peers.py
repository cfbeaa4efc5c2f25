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
        place = {joint["id"]: i for i, joint in enumerate(document["turningJoints"])}
        self.inputs = sorted(place[i["joint"]] for i in document["inputs"])
        self.outputs = [j for j in range(len(self.joints)) if j not in set(self.inputs)]


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
    return cycle_basis, sparse_linalg.spsolve(p[:, train.outputs], -p[:, train.inputs])


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
    return np.linalg.solve(p[:, train.outputs], -p[:, train.inputs])


def prepare(train):
    """What the dense and the symbolic peers are given for free: the weights as arrays."""
    graph = nx.Graph()
    for joint, (tail, head, axis) in enumerate(train.joints):
        graph.add_edge(tail, head, joint=joint, axis=axis, tail=tail)
    t = len(train.joints)
    train.rows = [mesh_row(train, graph, mesh) for mesh in train.meshes]
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
    right = -inputs * sympy.Matrix(sympy.symbols(f"u0:{inputs.shape[1]}"))  # a column for every input, as ours
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


def numpy_teeth():
    """Teeth of two pairs, 12 to 60, with 1/6.931 within 1/1000: how many, and the 20 nearest, in whole numbers."""
    pairs = np.multiply.outer(np.arange(12, 61), np.arange(12, 61)).ravel()
    apart = np.abs(6931 * pairs[:, None] - 1000 * pairs[None, :])
    within = np.nonzero(apart <= pairs[None, :])
    errors = apart[within] / pairs[within[1]]
    best = np.argsort(errors, kind="stable")[:20]
    return len(errors), within[0][best], within[1][best]


def main():
    folder = pathlib.Path(sys.argv[1])
    result = {}
    for family in ("tree", "coupled"):
        trains = {size: prepare(Train(folder / f"{family}-{size}.geargraph")) for size in (7, 20, 80, 1000, 10000)}
        result[f"networkx+scipy {family} 1000"] = best(lambda: networkx_scipy(trains[1000]))
        result[f"networkx+scipy {family} 10000"] = best(lambda: networkx_scipy(trains[10000]), 1)
        result[f"numpy dense {family} 1000"] = best(lambda: numpy_dense(trains[1000]))
        result[f"sympy LUsolve {family} 7"] = best(lambda: sympy_lusolve(trains[7]))
        result[f"sympy LUsolve {family} 20"] = best(lambda: sympy_lusolve(trains[20]), 1)
        result[f"sympy linsolve {family} 80"] = best(lambda: sympy_linsolve(trains[80]), 1)
        if family == "tree":
            result["numpy poses 1000"] = best(lambda: numpy_poses(trains[1000]))
    result["numpy teeth"] = best(numpy_teeth)
    result["numpy teeth within"] = numpy_teeth()[0]
    json.dump(result, sys.stdout, indent=1)


if __name__ == "__main__":
    main()
