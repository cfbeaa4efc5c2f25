// What the handout's scene needs of three.js; README.md has the command that makes three.min.js of it.
export {
  Box3, BufferAttribute, BufferGeometry, CanvasTexture, DirectionalLight, DoubleSide, EdgesGeometry, FrontSide, HemisphereLight,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshStandardMaterial, PerspectiveCamera, Quaternion, Raycaster, Scene, Sphere,
  Spherical, Sprite, SpriteMaterial, Vector2, Vector3, WebGLRenderer
} from 'three';
export {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
