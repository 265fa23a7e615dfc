/**
 * Writes parts of any plant as Wavefront OBJ with MTL: metres, +Y up, with every instance as a mesh. Objects have the
 * names of the GLB's nodes, with underscores for spaces. docs/export.md has the contents of the files.
 */
import type { Picture } from "../plant/material";
import { everyPart, type Part, type Shape, TRANSFORM } from "../plant/part";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { checkMeshBytes } from "./limits";
import { type NamedMaterial, writeMtl } from "./mtl";
import { ObjMaterials } from "./obj_materials";
import { ObjWriter } from "./obj_writer";
import { onePixel } from "./one_pixel";
import { palettedByMaterial } from "./palette";
import { png } from "./png";
import type { TextBuffer } from "./text_buffer";
import { placed, together } from "./together";

/** A picture that the MTL refers to. */
export interface ObjPicture {
	/** The name of its file, which is beside the MTL. */
	name: string;
	bytes: Uint8Array<ArrayBuffer>;
}

/**
 * Writes the two texts and their pictures.
 * @param name the name of the files without suffix: the OBJ refers to `name.mtl`
 * @param pictured whether the MTL may refer to pictures; else it has colours only
 * @throws FileTooLargeError where the OBJ exceeds the limit of files (limits.ts)
 */
export function exportObj(
	parts: Iterable<Part>,
	about: About,
	name: string,
	pictured = true,
): { obj: string; mtl: string; pictures: ObjPicture[] } {
	const { obj, ...others } = writeObj(parts, about, name, pictured);
	return { obj: obj.toString(), ...others };
}

/**
 * Writes a plant as an OBJ with its materials and pictures, as `exportObj`, but the OBJ in pieces
 * (`TextBuffer.chunks`): as one string it would be in memory twice.
 */
export function writeObj(
	parts: Iterable<Part>,
	about: About,
	name: string,
	pictured = true,
): { obj: TextBuffer; mtl: string; pictures: ObjPicture[] } {
	const own = [...parts];
	checkMeshBytes(own, "meshes");
	const all = [...everyPart(own.map(together))];
	const writer = new ObjWriter();
	writer.line(`# ${GENERATOR}: ${about.name}, metres, +Y up`);
	writer.line(`# ${about.link}`);
	writer.line(`mtllib ${name}.mtl`);
	const materials = new ObjMaterials();
	const shown = palettedByMaterial(all.flatMap(({ shape }) => shape ?? []));
	for (const { name, shape } of all) {
		const seen = shape && (shown.get(shape) ?? shape);
		if (seen) writeShape(writer, name, seen, materials.nameOf(seen));
	}
	const pictures = new Map<Picture, ObjPicture>();
	const named = materials
		.all()
		.map((each) => (pictured ? { ...each, pictures: picturesOf(each, name, pictures) } : each));
	return { obj: writer.text, mtl: writeMtl(named), pictures: [...pictures.values()] };
}

/**
 * Returns the names of a material's pictures, each of which is written once. A plain colour becomes a picture, too:
 * some readers take `Kd` for sRGB, Blender for linear light, and all of them take pictures for sRGB.
 */
function picturesOf({ name, material }: NamedMaterial, file: string, written: Map<Picture, ObjPicture>) {
	const kinds = (["colour", "normal"] as const).flatMap((kind) => {
		const picture = material.textures?.[kind] ?? (kind === "colour" ? onePixel(material.colour).picture : undefined);
		if (!picture) return [];
		const known = written.get(picture) ?? {
			name: `${file}-${name}-${kind}.png`.replaceAll(/[^A-Za-z0-9.-]+/g, "_"),
			bytes: png(picture),
		};
		written.set(picture, known);
		return [[kind, known.name]];
	});
	return Object.fromEntries(kinds);
}

/**
 * Writes a mesh, or each of its instances, as an object. Instances that are parts by themselves have their own names.
 */
function writeShape(writer: ObjWriter, name: string, { mesh, instances }: Shape, material: string): void {
	if (!instances) {
		writer.object(name, mesh, material);
		return;
	}
	const { transforms, each } = instances;
	for (let i = 0; i < transforms.length / TRANSFORM; i++) {
		const transform = transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1));
		const { uvs, indices } = mesh;
		writer.object(each ? each(i).name : name, { ...placed(mesh, transform), uvs, indices }, material);
	}
}
