/**
 * Trees of Panicle and of other libraries in one outdoor scene, drawn by stock three.js: runs in a page that Vite
 * serves. All trees of a species have one height, one sun, one ground and one camera.
 */
import * as three from "three";
import { TreeGenerator } from "three/addons/generators/TreeGenerator.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { Sky } from "three/addons/objects/Sky.js";

/** Height of a person's eyes above the ground; metres. */
const EYE = 1.7;
const FIELD = 34;
const SUN = new three.Vector3(-0.55, 0.72, 0.5).normalize();
/** Colours of the grass, and of the air at the horizon. */
const GRASS = new three.Color("#5f7040");
const HAZE = new three.Color("#b9c6d2");

/** Source of a tree: a GLB of Panicle, a preset of ez-tree, or settings of three.js' TreeGenerator. */
export type Source =
	| { readonly glb: string }
	| { readonly ezTree: string; readonly seed: number }
	| { readonly generator: Readonly<Record<string, unknown>>; readonly leaf: string; readonly seed: number };

export interface Picture {
	readonly source: Source;
	/** Height of the tree; metres. */
	readonly height: number;
	/** Whether the camera stands below the crown instead of in front of the whole tree. */
	readonly near: boolean;
	readonly width: number;
	readonly pixels: number;
}

/** Returns a picture of a tree as a PNG in base64. */
export async function pictureOf({ source, height, near, width, pixels }: Picture): Promise<string> {
	const canvas = document.createElement("canvas");
	const renderer = new three.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
	renderer.setSize(width, pixels, false);
	renderer.shadowMap.enabled = true;
	renderer.toneMapping = three.NeutralToneMapping;
	const scene = outdoors(renderer, height);
	const tree = await treeOf(source);
	scaleTo(tree, height);
	tree.traverse((object) => {
		object.castShadow = true;
		object.receiveShadow = true;
	});
	scene.add(tree);
	const camera = new three.PerspectiveCamera(FIELD, width / pixels, 0.05, 3000);
	const { min, max } = new three.Box3().setFromObject(tree, true);
	const half = Math.max(0.62 * height, (0.55 * (max.x - min.x) * pixels) / width);
	const away = near ? Math.max(4, 0.3 * height) : half / Math.tan((FIELD * Math.PI) / 360);
	camera.position.set(0.25 * away, EYE, 0.97 * away);
	camera.lookAt(0, near ? 0.34 * height : 0.5 * height, 0);
	renderer.render(scene, camera);
	// The textures of ez-tree are decoded after their materials are made.
	await new Promise((resolve) => setTimeout(resolve, 1500));
	renderer.render(scene, camera);
	const url = canvas.toDataURL("image/png");
	renderer.dispose();
	renderer.forceContextLoss();
	return url.slice(url.indexOf(",") + 1);
}

/** Returns a scene with the sky, its light, the sun and its shadows, and the ground. */
function outdoors(renderer: three.WebGLRenderer, height: number): three.Scene {
	const scene = new three.Scene();
	const sky = new Sky();
	sky.scale.setScalar(2000);
	const { uniforms } = sky.material as three.ShaderMaterial;
	uniforms.turbidity.value = 3;
	uniforms.rayleigh.value = 1.2;
	uniforms.mieCoefficient.value = 0.004;
	uniforms.sunPosition.value.copy(SUN);
	const ofSky = new three.Scene();
	ofSky.add(sky);
	scene.environment = new three.PMREMGenerator(renderer).fromScene(ofSky, 0, 0.1, 5000).texture;
	scene.environmentIntensity = 0.16;
	scene.background = HAZE;
	scene.fog = new three.Fog(HAZE, 20, 260);
	const sun = new three.DirectionalLight("#fff3dd", 3.4);
	sun.position.copy(SUN).multiplyScalar(4 * height);
	sun.castShadow = true;
	sun.shadow.mapSize.set(4096, 4096);
	sun.shadow.normalBias = 0.02;
	sun.shadow.bias = -0.0005;
	const { camera } = sun.shadow;
	camera.left = camera.bottom = -height;
	camera.right = camera.top = height;
	camera.far = 9 * height;
	scene.add(sun, new three.HemisphereLight("#d6dde4", "#77734f", 1.1));
	const ground = new three.Mesh(
		new three.CircleGeometry(600, 64).rotateX(-Math.PI / 2),
		new three.MeshStandardMaterial({ color: GRASS, roughness: 1, envMapIntensity: 0.4 }),
	);
	ground.receiveShadow = true;
	scene.add(ground);
	return scene;
}

/** Builds or loads a tree. */
async function treeOf(source: Source): Promise<three.Object3D> {
	if ("glb" in source) {
		const bytes = await (await fetch(source.glb)).arrayBuffer();
		return (await new GLTFLoader().parseAsync(bytes, "")).scene;
	}
	if ("ezTree" in source) {
		const { Tree } = await import("@dgreenheck/ez-tree");
		const tree = new Tree();
		tree.loadPreset(source.ezTree);
		tree.options.seed = source.seed;
		tree.generate();
		return tree;
	}
	return generated(source.generator, source.leaf, source.seed);
}

/** Builds the wood of three.js' generator, and a layer of leaves at the ends of its twigs, which it leaves to its users. */
function generated(settings: Readonly<Record<string, unknown>>, leaf: string, seed: number): three.Object3D {
	const bark = new three.MeshStandardMaterial({ color: "#6b5a48", roughness: 0.95 });
	const generator = new TreeGenerator(bark);
	Object.assign(generator.parameters, settings, { seed });
	const wood = generator.build();
	const tree = new three.Group();
	tree.add(wood);
	const points = wood.geometry.getAttribute("position");
	const shape = new three.Shape();
	shape.moveTo(0, 0);
	shape.quadraticCurveTo(0.5, 0.45, 0, 1);
	shape.quadraticCurveTo(-0.5, 0.45, 0, 0);
	const blade = new three.ShapeGeometry(shape, 4);
	const material = new three.MeshStandardMaterial({ color: leaf, roughness: 0.7, side: three.DoubleSide });
	const places: number[] = [];
	const random = randomBy(seed);
	// The first vertices are those of the trunk.
	for (let i = Math.floor(0.1 * points.count); i < points.count; i++) if (random() < 0.7) places.push(i);
	const leaves = new three.InstancedMesh(blade, material, places.length);
	const matrix = new three.Matrix4();
	for (const [k, i] of places.entries()) {
		const turn = new three.Quaternion().setFromEuler(
			new three.Euler(random() * Math.PI, random() * 2 * Math.PI, random() * Math.PI),
		);
		const size = 0.22 + 0.12 * random();
		matrix.compose(
			new three.Vector3().fromBufferAttribute(points as three.BufferAttribute, i),
			turn,
			new three.Vector3(size, size, size),
		);
		leaves.setMatrixAt(k, matrix);
	}
	tree.add(leaves);
	return tree;
}

/** Returns a function that returns random numbers from 0 to 1 (mulberry32). */
function randomBy(seed: number): () => number {
	let state = seed;
	return () => {
		state = (state + 0x6d2b79f5) | 0;
		let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
		mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
		return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
	};
}

/** Scales a tree to a height and puts its foot at the origin. */
function scaleTo(tree: three.Object3D, height: number): void {
	const box = new three.Box3().setFromObject(tree, true);
	const scale = height / box.max.y;
	tree.scale.multiplyScalar(scale);
}
