/** The paper's berries in a GLB: one mesh of unit radius, drawn by a node each or by instances. */
import type { Grown, Mesh } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import type { GltfDocument, Json, Placed } from "./gltf_document";
import { SCAR_TINT, skinMaterial } from "./materials";
import { berryName } from "./names";
import { shortFloat } from "./numbers";
import { turnOf, writtenTurn } from "./orientation";
import { scarShare } from "./scar";

const INSTANCING = "EXT_mesh_gpu_instancing";
const ORIGIN = [0, 0, 0];

/** Appends the node `Berries`, a group of one node per berry or the instances themselves; returns its index. */
export function addSharedBerries(
	document: GltfDocument,
	grown: Grown,
	berry: Mesh,
	look: Look,
	instancing: boolean,
): number {
	const material = document.material(skinMaterial(look));
	const colours = scarColours(berry);
	// Only where the mesh has a scale of its own does it need an origin.
	const placed = document.mesh("Berry", berry, material, document.compact ? { colours, centre: ORIGIN } : { colours });
	if (instancing) return document.node({ name: "Berries", mesh: placed.mesh, ...instances(document, grown, placed) });
	const children: number[] = [];
	const group = document.node({ name: "Berries", children });
	for (let i = 0; i < grown.berries.count; i++) children.push(document.node(berryNode(grown, i, placed)));
	return group;
}

function berryNode({ berries, internodes }: Grown, index: number, { mesh, scale = [1] }: Placed): Json {
	const { count, spheres, parent } = berries;
	const [x, y, z, radius] = Array.from(spheres.subarray(4 * index, 4 * index + 4), shortFloat);
	const size = scale[0] === 1 ? radius : shortFloat(Math.fround(radius * scale[0]));
	const pedicel = parent[index];
	return {
		name: berryName(index, count),
		mesh,
		translation: [x, y, z],
		rotation: writtenTurn(turnOf(berries.directions, index)),
		scale: [size, size, size],
		extras: { pedicel, axis: internodes.axis[pedicel] },
	};
}

function instances(document: GltfDocument, { berries }: Grown, { scale = [1] }: Placed): Json {
	const { count, spheres } = berries;
	const translations = new Float32Array(3 * count);
	const rotations = new Float32Array(4 * count);
	const scales = new Float32Array(3 * count);
	for (let i = 0; i < count; i++) {
		translations.set(spheres.subarray(4 * i, 4 * i + 3), 3 * i);
		const { x, y, z, w } = turnOf(berries.directions, i);
		rotations.set([x, y, z, w], 4 * i);
		scales.fill(spheres[4 * i + 3] * scale[0], 3 * i, 3 * i + 3);
	}
	document.require(INSTANCING);
	const attributes = {
		TRANSLATION: document.instances("translations", translations),
		ROTATION: document.instances("rotations", rotations),
		SCALE: document.instances("scales", scales),
	};
	return { extensions: { [INSTANCING]: { attributes } } };
}

/** Colours to multiply the skin with: white, brown at the tip scar. Four bytes a vertex. */
function scarColours(berry: Mesh): Uint8Array {
	const colours = new Uint8Array((berry.positions.length / 3) * 4).fill(255);
	for (let vertex = 0; vertex < colours.length / 4; vertex++) {
		const share = scarShare(berry.uvs[2 * vertex + 1]);
		if (share === 0) continue;
		SCAR_TINT.forEach((tint, channel) => {
			colours[4 * vertex + channel] = Math.round(255 * (1 + (tint - 1) * share));
		});
	}
	return colours;
}
