/** A boundary as a surface for display, metres, shaped as in the core (wasm-core/src/models/particles/boundary.cpp). */
import type { ClosedMesh } from "../../../../specimen/closed_mesh";
import type { BoundedSpecimen, Knot } from "../bounded";
import { type BoundaryLayout, outlineIn } from "./boundary_layout";
import { inBox } from "./mesh_outline";

/** Segments around a surface of revolution. */
const SIDES = 48;

/** Returns one surface per axis, and one for the inner boundary where that is a mesh. */
export function shellsOf<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): ClosedMesh[] {
	const { inner } = specimen.parameters;
	const shell =
		layout.form(specimen) === "mesh" && specimen.volume
			? inBox(specimen.volume)
			: surfaceOfRevolution(layout, specimen);
	const hollow = specimen.hollow && inner > 0 ? inBox(specimen.hollow) : undefined;
	return layout
		.axes(specimen)
		.flatMap((axis) => [
			toMetres(layout, specimen, shell, axis, 1),
			...(hollow ? [toMetres(layout, specimen, hollow, axis, inner)] : []),
		]);
}

/**
 * Scales a surface from shares of the boundary's box to metres about an axis; `size` is 1, or the inner boundary's
 * scale.
 */
function toMetres<S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
	specimen: S,
	{ points, triangles }: ClosedMesh,
	axis: number,
	size: number,
): ClosedMesh {
	const box = layout.box(specimen);
	const fixedHeight = layout.bareAbout(box);
	const origin = [axis, fixedHeight + size * (box.low - fixedHeight), 0];
	const scale = [box.halfWidth, box.high - box.low, layout.halfDepth(specimen)];
	return { points: points.map((share, i) => origin[i % 3] + size * share * scale[i % 3]), triangles };
}

/** Returns the surface of revolution of the outline; a box has four sides. */
function surfaceOfRevolution<S extends BoundedSpecimen>(layout: BoundaryLayout<S>, specimen: S): ClosedMesh {
	const outline = outlineIn(layout, specimen);
	const isBox = layout.form(specimen) === "box";
	const sides = isBox ? 4 : SIDES;
	const corner = (i: number): Knot => {
		const angle = (2 * Math.PI * (i + 0.5)) / sides;
		const radiusFactor = isBox ? Math.SQRT2 : 1;
		return [radiusFactor * Math.cos(angle), radiusFactor * Math.sin(angle)];
	};
	const points = outline.flatMap(([radius, height]) =>
		Array.from({ length: sides }, (_, i) => corner(i)).flatMap(([x, z]) => [radius * x, height, radius * z]),
	);
	const triangles = outline.slice(1).flatMap((_, ring) =>
		Array.from({ length: sides }, (_, i) => {
			const [a, b] = [ring * sides + i, ring * sides + ((i + 1) % sides)];
			return [a, a + sides, b, b, a + sides, b + sides];
		}).flat(),
	);
	return { points, triangles };
}
