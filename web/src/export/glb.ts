/**
 * Grown → binary glTF 2.0, in metres, +Y up. What is in the file, and why it is so, is in docs/export.md.
 */
import type { Grown, StemMesh } from "../models/bunch/grown";
import { encodeLink } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";
import { writtenSpecimen } from "../specimen/written";
import { addFoliage } from "./foliage";
import { GltfDocument, type Json } from "./gltf_document";
import { stemMaterial } from "./materials";
import { measuresOf } from "./measures";
import { cut, requireMeshes } from "./meshes";
import { plantName, stemName } from "./names";
import { addPressedBerries } from "./pressed_berries";
import { addSharedBerries } from "./shared_berries";
import { stemColours } from "./stem_colour";
import { vertexColours } from "./vertex_colours";

export interface GlbOptions {
	/**
	 * One node `Berries` drawn with EXT_mesh_gpu_instancing in place of one node per berry: smaller and faster, for
	 * readers that know the extension; others refuse the file. Passed over for natural bunches, whose berries
	 * share no mesh.
	 */
	instancing?: boolean;
	/** Positions in 16 bits and normals in 8, with KHR_mesh_quantization: about two thirds the size; readers must know it. */
	compact?: boolean;
	/** The link that brings the specimen back; without it the query alone, `?v=2&…`. */
	link?: string;
}

/**
 * The file. Rejects with a message for people when `grown` was asked for without meshes. `grown` is only read.
 */
export async function exportGlb(
	grown: Grown,
	specimen: Specimen,
	options: GlbOptions = {},
): Promise<Uint8Array<ArrayBuffer>> {
	const { instancing = false, compact = false, link = await encodeLink(specimen) } = options;
	const meshes = requireMeshes(grown);
	const document = new GltfDocument(compact);
	const root: Json = { name: plantName(specimen) };
	const roots = [document.node(root)];
	const children = addStems(document, grown, meshes.stem, specimen);
	if (meshes.surfaces) children.push(addPressedBerries(document, grown, meshes.surfaces, specimen));
	else if (meshes.berry) children.push(addSharedBerries(document, grown, meshes.berry, specimen.look, instancing));
	if (grown.foliage) children.push(...addFoliage(document, grown, grown.foliage));
	if (children.length > 0) root.children = children;
	return document.finish(roots, extrasOf(grown, specimen, link));
}

/** Where the file came from: enough to grow it again and to check that it is the same. */
function extrasOf(grown: Grown, specimen: Specimen, link: string): Json {
	const { procedure, plan, second, counts, fingerprint } = grown;
	return {
		link,
		specimen: writtenSpecimen(specimen),
		procedure,
		plan: { ...plan, second },
		counts,
		...measuresOf(grown),
		fingerprint,
	};
}

function addStems(document: GltfDocument, grown: Grown, stem: StemMesh, specimen: Specimen): number[] {
	const parts = stem.parts.filter((part) => part.indexCount > 0);
	if (parts.length === 0) return [];
	const shades = grown.procedure === "natural" ? vertexColours(stemColours(grown, stem, specimen)) : undefined;
	const material = document.material(stemMaterial(specimen.look, shades?.base));
	return parts.map((part) => {
		const name = stemName(part.axis);
		const { firstVertex, vertexCount } = part;
		const colours = shades?.bytes.subarray(4 * firstVertex, 4 * (firstVertex + vertexCount));
		const placed = document.mesh(name, cut(stem, part), material, colours ? { colours } : {});
		return document.node({ name, ...placed });
	});
}
