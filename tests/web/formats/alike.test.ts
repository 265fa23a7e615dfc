import { expect, it } from "vitest";
import { alike } from "../../../web/src/formats/alike";
import type { Material } from "../../../web/src/plant/material";
import { everyPart, type Part } from "../../../web/src/plant/part";
import { HAIR, PULP, tetrahedron } from "./toy_parts";

const SCAR = { ...tetrahedron([0, 0, 0], 0.1), name: "Scar" };

/** A body among others like it, with its parts: a scar of a material, and a hair of its own. */
function body(at: number, worn: Material): Part {
	const pose = Float32Array.of(at, 0, 0, 0, 0, 0, 1, 1);
	return {
		name: `Body ${at}`,
		shape: { mesh: tetrahedron([at, 0, 0], 1), material: PULP, pose },
		children: [
			{ name: `Scar ${at}`, shape: { mesh: SCAR, material: worn, instances: { transforms: pose } } },
			{ name: `Hair ${at}`, shape: { mesh: tetrahedron([at, 1, 0], 0.2), material: HAIR } },
		],
	};
}

it("joins what bodies bear by mesh and material, and keeps what is no instance", () => {
	const { children = [] } = alike({ name: "Bodies", children: [body(1, PULP), body(2, HAIR), body(3, PULP)] });
	const parts = [...everyPart(children)];
	expect(new Set(parts.map(({ name }) => name)).size).toBe(parts.length);
	const scars = parts.flatMap(({ shape }) => (shape?.mesh === SCAR ? [shape] : []));
	const places = ({ instances }: (typeof scars)[0]) => [...(instances?.transforms ?? [])].filter((_, i) => i % 8 === 0);
	expect(scars.map((shape) => [shape.material, places(shape)])).toEqual([
		[PULP, [1, 3]],
		[HAIR, [2]],
	]);
	expect(parts.map(({ name }) => name)).toEqual(expect.arrayContaining(["Hair 1", "Hair 2", "Hair 3"]));
});
