import type { LineSegments, Mesh, MeshBasicMaterial } from "three";
import { expect, it } from "vitest";
import { ShellRenderer } from "../../../web/src/render/shell_renderer";

const tetrahedron = (x: number) => ({
	points: [x, 0, 0, x + 1, 0, 0, x, 0, 1, x, 1, 0],
	triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2],
});

it("marks the faces and edges of the given shells only", () => {
	const renderer = new ShellRenderer();
	renderer.show([tetrahedron(0), tetrahedron(2), tetrahedron(4)], "#112233");
	const colours = () =>
		renderer.object.children.map(
			(part) => `#${((part as Mesh | LineSegments).material as MeshBasicMaterial).color.getHexString()}`,
		);
	renderer.mark(new Set([1]), "#ff0000");
	expect(colours()).toEqual(["#112233", "#112233", "#ff0000", "#ff0000", "#112233", "#112233"]);
	renderer.mark(new Set(), "#ff0000");
	expect(new Set(colours())).toEqual(new Set(["#112233"]));
	renderer.dispose();
});
