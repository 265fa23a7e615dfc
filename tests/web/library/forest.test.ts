import {
	BoxGeometry,
	BufferAttribute,
	Group,
	type InstancedMesh,
	Matrix4,
	Mesh,
	MeshStandardMaterial,
	PerspectiveCamera,
	PlaneGeometry,
	Texture,
	Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import { Forest, GameTree, type TreePlace } from "../../../web/src/library/forest/forest";

/** A tree of 10 m with levels of a box each, as a GLB has it. */
function scene(levels = 3): Group {
	const group = new Group();
	for (let level = 0; level < levels; level++) {
		const geometry = new BoxGeometry(2, 10, 2, 4 - level, 4 - level, 4 - level).translate(0, 5, 0);
		const colours = new Float32Array(4 * geometry.attributes.position.count).fill(0.5);
		geometry.setAttribute("color", new BufferAttribute(colours, 4));
		const mesh = new Mesh(geometry, new MeshStandardMaterial({ name: "Bark", vertexColors: true }));
		mesh.name = `Oak_LOD${level}`;
		group.add(mesh);
	}
	const collision = new Mesh(new BoxGeometry(1, 20, 1));
	collision.name = "UCX_Oak";
	return group.add(collision);
}

const impostor = {
	frames: 4,
	middle: [0, 5, 0] as const,
	radius: 5.5,
	colour: new Texture(),
	surface: new Texture(),
};
const camera = new PerspectiveCamera(60, 1, 0.1, 5000);
camera.position.set(0, 5, 0);
/** Places straight ahead at distances in metres. */
const ahead = (...distances: number[]): TreePlace[] =>
	distances.map((distance) => ({ tree: 0, position: [0, 0, -distance] }));
/** Distance at which a tree of 10 m has a size, as a share of the view's height. */
const distanceOf = (tree: GameTree, size: number) => 10 / (2 * size * Math.tan(Math.PI / 6)) + 0.5 * tree.radius;

describe("a game tree", () => {
	it("has the levels of its file by name, in metres, without the collision shape", () => {
		const tree = new GameTree({ scenes: [scene()] });
		expect(tree.levels.map((parts) => parts.length)).toEqual([1, 1, 1]);
		const counts = tree.levels.map(([{ geometry }]) => geometry.attributes.position.count);
		expect(counts).toEqual([...counts].sort((a, b) => b - a));
		expect(tree.height).toBe(10);
		expect(tree.radius).toBeCloseTo(0.5 * Math.hypot(2, 10, 2));
	});

	it("uses the transforms of the file", () => {
		const group = scene();
		group.scale.setScalar(0.5);
		expect(new GameTree({ scenes: [group] }).height).toBe(5);
	});

	it("has one level where the file names none", () => {
		const group = new Group().add(new Mesh(new PlaneGeometry(1, 4).translate(0, 2, 0), new MeshStandardMaterial()));
		expect(new GameTree({ scenes: [group] }).levels.map((parts) => parts.length)).toEqual([1]);
	});
});

describe("a game tree with an impostor", () => {
	it("draws it in place of its last level, and uses the sizes of the description", () => {
		const tree = new GameTree({ scenes: [scene(1), scene(4)] }, { impostor, sizes: [0.5, 0.2, 0.07] });
		expect(tree.levels).toHaveLength(3);
		const forest = new Forest([tree], ahead(...[0.7, 0.4, 0.1, 0.05].map((size) => distanceOf(tree, size))));
		expect(forest.update(camera, 0)).toEqual([1, 1, 1, 1]);
	});
});

describe("a forest", () => {
	it("draws each tree at the level of its size in the view, the smallest as impostors", () => {
		const tree = new GameTree({ scenes: [scene(4)] }, { impostor });
		const sizes = [1.2, 0.5, 0.4, 0.15, 0.05, 0.04, 0.03];
		const forest = new Forest([tree], ahead(...sizes.map((size) => distanceOf(tree, size))));
		expect(forest.update(camera, 0)).toEqual([1, 2, 1, 3]);
	});

	it("uses the sizes that are set", () => {
		const tree = new GameTree({ scenes: [scene()] });
		const places = ahead(...[1.2, 0.5, 0.15].map((size) => distanceOf(tree, size)));
		expect(new Forest([tree], places, { sizes: [2, 1] }).update(camera, 0)).toEqual([0, 1, 2]);
		expect(new Forest([tree], places, { sizes: [0.01, 0.001] }).update(camera, 0)).toEqual([3, 0, 0]);
	});

	it("does not draw trees outside the view", () => {
		const tree = new GameTree({ scenes: [scene()] });
		const places: TreePlace[] = [
			{ tree: 0, position: [0, 0, 30] },
			{ tree: 0, position: [500, 0, -30] },
			{ tree: 0, position: [0, 0, -30] },
		];
		expect(new Forest([tree], places).update(camera, 0).reduce((sum, count) => sum + count)).toBe(1);
	});

	it("fades between two levels so that both together cover every pixel once", () => {
		const tree = new GameTree({ scenes: [scene()] });
		const forest = new Forest([tree], ahead(distanceOf(tree, 0.26 * 1.1)));
		expect(forest.update(camera, 0)).toEqual([0, 1, 1]);
		const fades = forest.children
			.filter((each) => each.visible)
			.map((each) => (each as InstancedMesh).geometry.attributes.instanceFade.array[0]);
		expect(fades[0]).toBeGreaterThan(0);
		expect(fades[0]).toBeLessThan(1);
		expect(fades[1]).toBe(-fades[0]);
	});

	it("places trees with their rotation and scale, also in a moved group", () => {
		const tree = new GameTree({ scenes: [scene()] });
		const place = { tree: 0, position: [3, 1, -20] as const, rotation: 0.5, scale: 2 };
		const forest = new Forest([tree], [place]);
		forest.position.set(0, 0, -1000);
		expect(forest.update(camera, 0)).toEqual([0, 0, 1]);
		forest.position.set(0, 0, 0);
		forest.update(camera, 0);
		const drawn = forest.children.find((each) => each.visible) as InstancedMesh;
		const matrix = new Matrix4();
		drawn.getMatrixAt(0, matrix);
		const [position, scale] = [new Vector3().setFromMatrixPosition(matrix), new Vector3().setFromMatrixScale(matrix)];
		expect(position.toArray()).toEqual([3, 1, -20]);
		expect(scale.x).toBeCloseTo(2);
	});

	it("uses vertex colours as wind data, and nothing moves without them", () => {
		const plain = scene();
		plain.traverse((object) => object instanceof Mesh && object.geometry.deleteAttribute("color"));
		for (const [tree, value] of [
			[new GameTree({ scenes: [scene()] }), 0.5],
			[new GameTree({ scenes: [plain] }), 0],
		] as const) {
			const forest = new Forest([tree], ahead(20));
			const { geometry, material } = forest.children[0] as InstancedMesh;
			expect(geometry.attributes.color).toBeUndefined();
			expect(geometry.attributes.windData.getY(0)).toBe(value);
			expect((material as MeshStandardMaterial).vertexColors).toBe(false);
		}
	});

	it("uses the second vertex colours where the file has both", () => {
		const group = scene();
		group.traverse((object) => {
			if (!(object instanceof Mesh)) return;
			const { position } = object.geometry.attributes;
			object.geometry.setAttribute("color_1", new BufferAttribute(new Float32Array(4 * position.count).fill(0.25), 4));
		});
		const forest = new Forest([new GameTree({ scenes: [group] })], ahead(20));
		expect((forest.children[0] as InstancedMesh).geometry.attributes.windData.getX(0)).toBe(0.25);
	});

	it("reports a place of a kind that does not exist", () => {
		expect(() => new Forest([new GameTree({ scenes: [scene()] })], [{ tree: 1, position: [0, 0, 0] }])).toThrow(
			new RangeError("There is no kind 1: the forest has 1 kinds."),
		);
	});

	it("chooses levels for 2,000 trees in less than 20 ms", () => {
		const tree = new GameTree({ scenes: [scene(4)] }, { impostor });
		const places = Array.from({ length: 2000 }, (_, i): TreePlace => {
			return { tree: 0, position: [((i * 7) % 400) - 200, 0, -((i * 13) % 600)] };
		});
		const forest = new Forest([tree], places);
		const times = Array.from({ length: 20 }, (_, k) => {
			const from = performance.now();
			forest.update(camera, k);
			return performance.now() - from;
		});
		expect(Math.min(...times)).toBeLessThan(20);
	});
});
