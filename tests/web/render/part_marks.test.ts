import { Group, type Mesh, Vector3 } from "three";
import { expect, it } from "vitest";
import type { Part } from "../../../web/src/plant/part";
import { PAPER } from "../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../web/src/render/paper_shadow";
import { partRenderer } from "../../../web/src/render/part_renderer";
import { StageLight } from "../../../web/src/render/stage_light";
import { windUniforms } from "../../../web/src/render/wind_shader";
import { PULP, tetrahedron } from "../formats/toy_parts";

it("marks triangles by separate geometry, so that disposing of a mark leaves the plant's buffers", () => {
	const stage = {
		root: new Group(),
		light: new StageLight(),
		shadow: new PaperShadow(),
		wind: windUniforms(),
		setting: PAPER,
	};
	const renderer = partRenderer<unknown, Part[]>((parts) => parts)(stage);
	const mesh = { ...tetrahedron([0, 0, 0], 1), pickIds: Uint32Array.of(1, 2, 2, 1) };
	renderer.show([{ name: "Petal", shape: { mesh, material: PULP } }], {});
	const [shown] = stage.root.children.filter((child): child is Mesh => "isMesh" in child);
	renderer.mark(1);
	const mark = stage.root.children.at(-1) as Mesh;
	const shared = Object.values(mark.geometry.attributes).filter((attribute) =>
		Object.values(shown.geometry.attributes).includes(attribute),
	);
	expect(shared).toEqual([]);
	// And the same triangles.
	const cornersOf = ({ geometry }: Mesh, corners: number[]) =>
		corners.map((corner) => new Vector3().fromBufferAttribute(geometry.attributes.position, corner).toArray());
	const all = [...(shown.geometry.index?.array ?? [])];
	const own = [...(mark.geometry.index?.array ?? [])];
	expect(cornersOf(mark, own)).toEqual(cornersOf(shown, [...all.slice(0, 3), ...all.slice(9)]));
	const normals = (mark.geometry.attributes.normal as unknown as { count: number }).count;
	expect(normals).toBe(mark.geometry.attributes.position.count);
});
