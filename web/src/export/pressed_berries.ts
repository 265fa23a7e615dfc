/**
 * Natural berries in a GLB: each its own mesh about its own centre, so that it can be moved; texture coordinates and
 * triangles of one pattern; one material; flowers that have not set as children of their berries.
 */
import type { BerrySurfaces, Grown, Mesh } from "../models/bunch/grown";
import type { Specimen } from "../specimen/specimen";
import { berryColours } from "./berry_colour";
import { type Flowers, flowerOf } from "./flowers";
import type { GltfDocument, Json } from "./gltf_document";
import { ANTHER_TINT, pressedSkin, STAMEN } from "./materials";
import { meanOf } from "./meshes";
import { berryName, flowerName } from "./names";
import { shortFloat } from "./numbers";
import { turnOf, writtenTurn } from "./orientation";
import { traitOf } from "./traits";
import { vertexColours } from "./vertex_colours";

const ORIGIN = [0, 0, 0];
/** Where filaments end and anthers begin (models/bunch/fruit/flower.hpp). */
const ANTHER_V = 0.5;

/** Appends the group `Berries`; returns its index. */
export function addPressedBerries(
	document: GltfDocument,
	grown: Grown,
	surfaces: BerrySurfaces,
	specimen: Specimen,
): number {
	const { count, spheres } = grown.berries;
	const vertices = surfaces.uvs.length / 2;
	const { base, bytes } = vertexColours(berryColours(grown, surfaces, specimen));
	const width = meanOf(grown, "width");
	// Compact meshes reach from −1 to 1, each scaled by its own node.
	const thickness = document.compact ? 2 : width;
	const material = document.material(pressedSkin(specimen.look, grown.form.fruit, base, width, thickness));
	const pattern = document.pattern(surfaces);
	const nodes: Json[] = [];
	const children: number[] = [];
	const group = document.node({ name: "Berries", children });
	for (let i = 0; i < count; i++) {
		const [first, last] = [i * vertices, (i + 1) * vertices];
		const mesh = {
			positions: surfaces.positions.subarray(3 * first, 3 * last),
			normals: surfaces.normals.subarray(3 * first, 3 * last),
		};
		const name = berryName(i, count);
		const centre = Array.from(spheres.subarray(4 * i, 4 * i + 3));
		const colours = bytes.subarray(4 * first, 4 * last);
		const placed = document.mesh(name, mesh, material, { centre, colours, pattern });
		const node: Json = { name, ...placed, extras: berryExtras(grown, i) };
		nodes.push(node);
		children.push(document.node(node));
	}
	const flowers = flowerOf(grown);
	if (flowers) addFlowers(document, grown, flowers, nodes);
	return group;
}

/** What is known of one berry, for whoever selects it; lengths in metres. */
export function berryExtras({ berries, internodes }: Grown, index: number): Json {
	const pedicel = berries.parent[index];
	const trait = (name: Parameters<typeof traitOf>[2]) => shortFloat(traitOf(berries, index, name));
	return {
		id: berries.ids[index],
		pedicel,
		axis: internodes.axis[pedicel],
		radius: shortFloat(berries.spheres[4 * index + 3]),
		width: trait("width"),
		length: trait("length"),
		direction: Array.from(berries.directions.subarray(3 * index, 3 * index + 3), shortFloat),
		exposure: trait("exposure"),
		turned: trait("turned"),
	};
}

/** Each flower is a child of its berry's node, whose own scale it must undo: moved, the berry takes it along. */
function addFlowers(document: GltfDocument, grown: Grown, flowers: Flowers, nodes: readonly Json[]): void {
	const { mesh, shares } = flowers;
	const options = { colours: antherColours(mesh), ...(document.compact ? { centre: ORIGIN } : {}) };
	const flower = document.mesh("Flower", mesh, document.material(STAMEN), options);
	const { count, spheres, directions } = grown.berries;
	for (const [i, share] of shares) {
		const [own, above] = [flower.scale?.[0] ?? 1, (nodes[i].scale as number[] | undefined)?.[0] ?? 1];
		const size = shortFloat(Math.fround((share * spheres[4 * i + 3] * own) / above));
		const child = document.node({
			name: flowerName(i, count),
			mesh: flower.mesh,
			rotation: writtenTurn(turnOf(directions, i)),
			scale: [size, size, size],
		});
		nodes[i].children = [child];
	}
}

/** White filaments, anthers of pollen's colour. */
function antherColours(flower: Mesh): Uint8Array {
	const colours = new Uint8Array((flower.positions.length / 3) * 4).fill(255);
	for (let vertex = 0; vertex < colours.length / 4; vertex++) {
		if (flower.uvs[2 * vertex + 1] <= ANTHER_V) continue;
		ANTHER_TINT.forEach((tint, channel) => {
			colours[4 * vertex + channel] = Math.round(255 * tint);
		});
	}
	return colours;
}
