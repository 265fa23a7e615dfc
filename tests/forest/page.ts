/** A page with forests (library/forest), for tests in a browser (tests/e2e/forest.spec.ts): a tree made here, its impostor, and pictures of both. */
import {
	AmbientLight,
	BufferAttribute,
	type BufferGeometry,
	CanvasTexture,
	Color,
	CylinderGeometry,
	DirectionalLight,
	DoubleSide,
	Group,
	Mesh,
	MeshBasicMaterial,
	MeshStandardMaterial,
	OrthographicCamera,
	PerspectiveCamera,
	PlaneGeometry,
	Scene,
	ShaderMaterial,
	Vector3,
	WebGLRenderer,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { Forest, GameTree, type Impostor, type TreePlace } from "../../web/src/library/forest/forest";

const SIDE = 256;
const renderer = new WebGLRenderer({ preserveDrawingBuffer: true, alpha: true });
const problems: string[] = [];
renderer.debug.onShaderError = (gl, _, vertex, fragment) => {
	problems.push(gl.getShaderInfoLog(vertex) || gl.getShaderInfoLog(fragment) || "cannot be linked");
};

/** Gives each vertex wind data by its height. */
function windy(geometry: BufferGeometry, data: (y: number) => number[]): BufferGeometry {
	const { position } = geometry.attributes;
	const colours = Array.from({ length: position.count }, (_, i) => data(position.getY(i))).flat();
	return geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 4));
}

/** A tree of 8 m: a trunk, and a crooked crown of cards, the same at all levels. */
function scene(): Group {
	const trunk = windy(new CylinderGeometry(0.15, 0.3, 5, 12).translate(0, 2.5, 0), () => [0, 0, 0, 1]);
	const cards = Array.from({ length: 120 }, (_, k) => {
		const turn = 2.4 * k;
		const out = 2.2 * Math.sqrt((0.618 * k) % 1);
		const card = new PlaneGeometry(0.9, 0.9).rotateX(0.7 * Math.sin(k)).rotateY(turn);
		card.translate(out * Math.cos(turn) + 0.6, 3.5 + 4 * ((0.37 * k) % 1), 0.7 * out * Math.sin(turn));
		return windy(card, () => [(0.13 * k) % 1, 0.7, 0.1 + 0.9 * ((0.29 * k) % 1), 0.8]);
	});
	const group = new Group();
	for (let level = 0; level < 2; level++) {
		const bark = new MeshStandardMaterial({ name: "Bark", color: 0x6b5438, vertexColors: true });
		const leaf = new MeshStandardMaterial({ name: "Leaves", color: 0x4f8a2c, side: DoubleSide, vertexColors: true });
		const part = new Group();
		part.name = `Tree_LOD${level}`;
		part.add(new Mesh(trunk, bark), new Mesh(mergeGeometries(cards), leaf));
		group.add(part);
	}
	return group;
}

/** Direction of a picture, from the place in the grid: as the documentation of the archive defines it. */
function directionOf(column: number, row: number, frames: number): Vector3 {
	const [u, v] = [(2 * column) / (frames - 1) - 1, (2 * row) / (frames - 1) - 1];
	const [x, z] = [0.5 * (u + v), 0.5 * (u - v)];
	return new Vector3(x, 1 - Math.abs(x) - Math.abs(z), z).normalize();
}

/** Draws the impostor of a tree with three.js: an independent implementation of the pictures' definition. */
function bake(tree: Group, frames: number, edge: number): Impostor {
	const [middle, radius] = [[0.5, 4, 0] as const, 5];
	const fine = tree.getObjectByName("Tree_LOD0") as Group;
	const baked = new Scene().add(fine.clone());
	const normals = new ShaderMaterial({
		side: DoubleSide,
		vertexShader:
			"varying vec3 n; void main() { n = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
		fragmentShader: "varying vec3 n; void main() { gl_FragColor = vec4(0.5 + 0.5 * normalize(n), 1.0); }",
	});
	const picture = (isColour: boolean) => {
		const canvas = Object.assign(document.createElement("canvas"), { width: frames * edge, height: frames * edge });
		const context = canvas.getContext("2d") as CanvasRenderingContext2D;
		baked.traverse((object) => {
			if (!(object instanceof Mesh)) return;
			const { color } = object.userData.own ?? object.material;
			object.userData.own ??= object.material;
			object.material = isColour ? new MeshBasicMaterial({ color, side: DoubleSide }) : normals;
		});
		renderer.setSize(edge, edge);
		renderer.setClearColor(0, 0);
		const camera = new OrthographicCamera(-radius, radius, radius, -radius, 0.1, 4 * radius);
		for (let row = 0; row < frames; row++) {
			for (let column = 0; column < frames; column++) {
				const towards = directionOf(column, row, frames);
				camera.position.set(...middle).addScaledVector(towards, 2 * radius);
				camera.up.set(0, 1, 0);
				if (towards.y > 0.999) camera.up.set(0, 0, -1);
				camera.lookAt(...middle);
				renderer.render(baked, camera);
				context.drawImage(renderer.domElement, column * edge, row * edge);
			}
		}
		return new CanvasTexture(canvas);
	};
	return { frames, middle, radius, colour: picture(true), surface: picture(false) };
}

/** Options of a picture of a forest. */
export interface ForestPicture {
	/** Whether the trees are drawn as impostors. */
	impostor?: boolean;
	wind?: number;
	seconds?: number;
	/** From the eye to the tree, metres; and its direction, radians from above the ground and around the tree. */
	distance?: number;
	above?: number;
	around?: number;
	places?: TreePlace[];
	sizes?: number[];
	background?: number;
}

const tree = scene();
const meshes = new GameTree({ scenes: [tree] });
let pictured: GameTree | undefined;

/** Draws a forest, and returns its pixels from the top down, and the numbers of trees at each level. */
function draw(options: ForestPicture): { pixels: number[]; counts: number[]; problems: string[]; calls: number } {
	const { impostor = false, wind = 0, seconds = 0, distance = 16, above = 0.15, around = 0.4 } = options;
	pictured ??= new GameTree({ scenes: [tree] }, { impostor: bake(tree, 12, 128) });
	const forest = new Forest([impostor ? pictured : meshes], options.places ?? [{ tree: 0, position: [0, 0, 0] }], {
		wind,
		sizes: options.sizes ?? (impostor ? [100] : [0.001]),
	});
	const world = new Scene().add(forest, new AmbientLight(0xffffff, 1.5));
	world.background = new Color(options.background ?? 0xffffff);
	const sun = new DirectionalLight(0xffffff, 2.5);
	sun.position.set(2, 3, 2);
	world.add(sun);
	const camera = new PerspectiveCamera(40, 1, 0.1, 1000);
	const level = distance * Math.cos(above);
	camera.position.set(level * Math.sin(around), 4 + distance * Math.sin(above), level * Math.cos(around));
	camera.lookAt(0, 4, 0);
	renderer.setSize(SIDE, SIDE);
	const counts = forest.update(camera, seconds);
	renderer.render(world, camera);
	const { calls } = renderer.info.render;
	const copy = Object.assign(document.createElement("canvas"), { width: SIDE, height: SIDE });
	const context = copy.getContext("2d") as CanvasRenderingContext2D;
	context.drawImage(renderer.domElement, 0, 0);
	const { data } = context.getImageData(0, 0, SIDE, SIDE);
	forest.dispose();
	return { pixels: [...data], counts, problems: [...problems], calls };
}

const tools = { draw };
export type Forests = typeof tools;
Object.assign(window, { forests: tools });
