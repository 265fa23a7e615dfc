/**
 * Grown → Wavefront OBJ with MTL, as the paper exports: metres, +Y up, every berry baked. The objects have the names
 * of the GLB's nodes, with underscores for spaces. What is in the files is in docs/export.md.
 */
import type { BerrySurfaces, Grown, Mesh, StemMesh } from "../models/bunch/grown";
import { encodeQuery } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";
import { berryColours } from "./berry_colour";
import type { Colour } from "./colour";
import { flowerOf } from "./flowers";
import { foliageMaterials } from "./foliage";
import { GENERATOR } from "./generator";
import { pressedSkin, STAMEN, skinMaterial, stemMaterial } from "./materials";
import { cut, meanOf, requireMeshes } from "./meshes";
import { type NamedMaterial, writeMtl } from "./mtl";
import { berryName, flowerName, foliageNames, plantName, stemName } from "./names";
import { ObjWriter } from "./obj_writer";
import { type Rows, rows, turnOf } from "./orientation";
import { stemColours } from "./stem_colour";
import { traitOf } from "./traits";
import { meanColour } from "./vertex_colours";

/** What a vertex is likely to take with its share of the faces, in bytes; only a guess to begin with. */
const BYTES_PER_VERTEX = 160;
/** Ripeness is told in steps of this many percent: a material for each, as OBJ knows no colours of vertices. */
const RIPENESS_STEP = 25;

/**
 * The two texts. `name` is what the files are called without their endings: the OBJ asks for `name.mtl`. Throws when
 * `grown` was asked for without meshes.
 */
export function exportObj(grown: Grown, specimen: Specimen, name: string): { obj: string; mtl: string } {
	const { stem, berry, surfaces } = requireMeshes(grown);
	const ofBerries = surfaces?.positions.length ?? grown.berries.count * (berry?.positions.length ?? 0);
	const writer = new ObjWriter((BYTES_PER_VERTEX * (stem.positions.length + ofBerries)) / 3);
	writer.line(`# ${GENERATOR}: ${plantName(specimen)}, metres, +Y up`);
	writer.line(`# ${encodeQuery(specimen)}`);
	writer.line(`mtllib ${name}.mtl`);
	for (const part of stem.parts) {
		if (part.indexCount > 0) writer.object(stemName(part.axis), cut(stem, part), "Stem");
	}
	const skins: NamedMaterial[] = [];
	if (surfaces) skins.push(...writePressed(writer, grown, surfaces, specimen));
	else if (berry) skins.push(writeShared(writer, grown, berry, specimen));
	const stemLook = { name: "Stem", material: stemMaterial(specimen.look, stemColour(grown, stem, specimen)) };
	const others = [...writeFlowers(writer, grown), ...writeFoliage(writer, grown)];
	return { obj: writer.toString(), mtl: writeMtl([...skins, stemLook, ...others]) };
}

type Vector = [x: number, y: number, z: number];

/** The paper's berries: one mesh, turned, scaled and moved; all share one run of texture coordinates. */
function writeShared(writer: ObjWriter, { berries }: Grown, berry: Mesh, { look }: Specimen): NamedMaterial {
	const firstUv = writer.textureCoordinates(berry.uvs);
	const turned = new Float64Array(berry.positions.length);
	for (let i = 0; i < berries.count; i++) {
		const [x, y, z, radius] = berries.spheres.subarray(4 * i, 4 * i + 4);
		const turn = rows(turnOf(berries.directions, i));
		writer.object(berryName(i, berries.count));
		writer.positions(placed(berry.positions, turn, radius, [x, y, z], turned));
		writer.normals(placed(berry.normals, turn, 1, [0, 0, 0], turned));
		writer.faces(berry.indices, "Skin", firstUv);
	}
	return { name: "Skin", material: skinMaterial(look) };
}

/** Natural berries as they are. Their skins come in steps of ripeness, each of the mean colour of its berries. */
function writePressed(writer: ObjWriter, grown: Grown, surfaces: BerrySurfaces, specimen: Specimen): NamedMaterial[] {
	const { berries, form } = grown;
	const vertices = surfaces.uvs.length / 2;
	const colours = berryColours(grown, surfaces, specimen);
	const firstUv = writer.textureCoordinates(surfaces.uvs);
	const skins = new Map<string, { sum: Colour; count: number }>();
	for (let i = 0; i < berries.count; i++) {
		const [first, last] = [3 * i * vertices, 3 * (i + 1) * vertices];
		const name = skinName(traitOf(berries, i, "turned"));
		const skin = skins.get(name) ?? { sum: [0, 0, 0], count: 0 };
		meanColour(colours.subarray(first, last)).forEach((value, channel) => {
			skin.sum[channel] += value;
		});
		skin.count++;
		skins.set(name, skin);
		writer.object(berryName(i, berries.count));
		writer.positions(surfaces.positions.subarray(first, last));
		writer.normals(surfaces.normals.subarray(first, last));
		writer.faces(surfaces.indices, name, firstUv);
	}
	return [...skins].map(([name, { sum, count }]) => {
		const colour = sum.map((value) => value / count) as Colour;
		return { name, material: pressedSkin(specimen.look, form.fruit, colour, meanOf(grown, "width")) };
	});
}

/** `Skin` of ripe berries, `Skin_0` … `Skin_75` of others. */
function skinName(turned: number): string {
	const percent = RIPENESS_STEP * Math.round((100 * turned) / RIPENESS_STEP);
	return percent === 100 ? "Skin" : `Skin_${percent}`;
}

function stemColour(grown: Grown, stem: StemMesh, specimen: Specimen): Colour | undefined {
	if (grown.procedure === "paper" || stem.positions.length === 0) return undefined;
	return meanColour(stemColours(grown, stem, specimen));
}

function writeFlowers(writer: ObjWriter, grown: Grown): NamedMaterial[] {
	const flowers = flowerOf(grown);
	if (!flowers) return [];
	const { mesh, shares } = flowers;
	const { count, spheres, directions } = grown.berries;
	const firstUv = writer.textureCoordinates(mesh.uvs);
	const turned = new Float64Array(mesh.positions.length);
	for (const [i, share] of shares) {
		const [x, y, z, radius] = spheres.subarray(4 * i, 4 * i + 4);
		const turn = rows(turnOf(directions, i));
		writer.object(flowerName(i, count));
		writer.positions(placed(mesh.positions, turn, share * radius, [x, y, z], turned));
		writer.normals(placed(mesh.normals, turn, 1, [0, 0, 0], turned));
		writer.faces(mesh.indices, STAMEN.name, firstUv);
	}
	return [{ name: STAMEN.name, material: STAMEN }];
}

function writeFoliage(writer: ObjWriter, grown: Grown): NamedMaterial[] {
	const { foliage } = grown;
	if (!foliage) return [];
	const materials = foliageMaterials(grown);
	const names = foliageNames(foliage.parts);
	const used = new Map<string, NamedMaterial>();
	foliage.parts.forEach((part, index) => {
		if (part.indexCount === 0) return;
		const material = materials[part.kind];
		used.set(part.kind, { name: material.name, material });
		writer.object(names[index], cut(foliage, part), material.name);
	});
	return [...used.values()];
}

/** `vectors` turned, scaled and moved, written into `into` and returned. */
function placed(vectors: Float32Array, turn: Rows, scale: number, centre: Vector, into: Float64Array): Float64Array {
	const [a, b, c, d, e, f, g, h, k] = turn;
	const [cx, cy, cz] = centre;
	for (let i = 0; i < vectors.length; i += 3) {
		const x = vectors[i];
		const y = vectors[i + 1];
		const z = vectors[i + 2];
		into[i] = cx + scale * (a * x + b * y + c * z);
		into[i + 1] = cy + scale * (d * x + e * y + f * z);
		into[i + 2] = cz + scale * (g * x + h * y + k * z);
	}
	return into;
}
