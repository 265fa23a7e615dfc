/**
 * The *game* form: a tree for games as a ZIP archive. It has one GLB with four levels of detail and a body for
 * collisions, an octahedral impostor, and a description of the data. docs/for-game-developers.md explains them.
 */
import { type Zippable, zipSync } from "fflate";
import { meanColour } from "../../plant/colour";
import type { Material, Picture } from "../../plant/material";
import type { Part, PartMesh, Vector } from "../../plant/part";
import type { Wooden } from "../../plant/wood/wooden";
import type { About } from "../about";
import { type CardLevel, type CardTree, cardTree, FINEST_LEVEL, type LevelOptions } from "../cards/card_tree";
import { type Drawn, linearPicture } from "../cards/raster";
import { FileError } from "../file_error";
import { GltfDocument, type Json } from "../gltf_document";
import { gltfMaterial } from "../gltf_material";
import { text } from "../messages.generated";
import { boundsOf } from "../piece";
import { png } from "../png";
import { shrunk } from "../shrunk";
import { tangentsOf } from "../tangents";
import { brightest, sharesOf } from "../vertex_colours";
import { ZIP_DATE } from "../zip_date";
import { crossedPictures, drawImpostor, FRAMES, type Impostor } from "./impostor";
import { readme } from "./readme";
import { trunkHull } from "./trunk_hull";
import { type LevelWind, type PivotBox, WindPainter } from "./wind_data";

/** The levels made of triangles, the finest first. */
export const GAME_LEVELS: readonly LevelOptions[] = [
	FINEST_LEVEL,
	{ triangles: 6000, wood: 0.3, tolerance: 0.005, sides: [7, 5, 3, 3], share: 0.38 },
	{ triangles: 1500, wood: 0.3, tolerance: 0.01, sides: [5, 4, 3, 3], share: 0.22 },
];
/** The least share of the view's area at which each level is shown, as in `MSFT_screencoverage`. */
const COVERAGE = [0.25, 0.04, 0.005, 0];
/** The edge of the atlas, and of pictures of bark and of its normals, in pixels. */
const ATLAS = 512;
const BARK = 256;
const NORMALS = 128;
/** Positions are multiples of a 256th of a metre, normals of a 256th: archives become a third smaller. */
const PLACE_STEPS = 256;
const NORMAL_STEPS = 256;

/** Writes the archive. Throws a FileError for plants that are no trees with leaves. */
export function gameTree(
	parts: Iterable<Part>,
	about: About,
	plant: Wooden | undefined,
	windColours = false,
): Uint8Array<ArrayBuffer> {
	const tree = plant && cardTree([...parts], plant, GAME_LEVELS, ATLAS);
	if (!tree) throw new FileError(text.message("no_game_tree"));
	const name = titleOf(about.name);
	const { glb, impostor, described } = new GameTreeWriter(name, tree, about, windColours).write();
	const encoder = new TextEncoder();
	const files: Zippable = {
		[`${name}.glb`]: glb,
		[`${name}_Impostor.png`]: [impostor.colourPng, { level: 0 }],
		[`${name}_Impostor_Surface.png`]: [impostor.surfacePng, { level: 0 }],
		[`${name}.json`]: encoder.encode(`${JSON.stringify(described, undefined, "\t")}\n`),
		"README.txt": encoder.encode(readme(name, about.link)),
	};
	return zipSync(files, { level: 6, mtime: ZIP_DATE }) as Uint8Array<ArrayBuffer>;
}

/** Returns the name of a preset without spaces: `StonePine` of "Growth stone-pine". */
function titleOf(name: string): string {
	const words = name.split(/[^A-Za-z0-9]+/).slice(1);
	const title = words.map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join("");
	return title === "" ? "Tree" : title;
}

/** The colour of the body for collisions. */
const GREY: [number, number, number] = [0.5, 0.5, 0.5];

class GameTreeWriter {
	readonly #document = new GltfDocument(false);

	constructor(
		readonly name: string,
		readonly tree: CardTree,
		readonly about: About,
		readonly windColours: boolean,
	) {}

	/** Writes the GLB; returns it with the impostor and the description. */
	write(): { glb: Uint8Array<ArrayBuffer>; impostor: Impostor; described: Json } {
		const { name, tree } = this;
		const document = this.#document;
		const box = boxOf(tree.levels[0]);
		const painter = new WindPainter(tree.skeleton, box, skyOf(tree.levels[0]));
		const barkBase = tree.levels.reduce<[number, number, number]>(
			(base, { tubes }) => (tubes.mesh.colours ? brightest(tubes.mesh.colours, base) : base),
			[0, 0, 0],
		);
		const hasColours = tree.levels[0].tubes.mesh.colours !== undefined;
		const bark = this.#material(`${name}_Bark`, tree.bark, hasColours ? barkBase : undefined, BARK);
		const leaves = this.#material(`${name}_Leaves`, tree.leaves, undefined, ATLAS);
		const ball = ballOf(tree.levels[1]);
		const impostor = drawImpostor(drawnLevel(tree.levels[1], tree), ball);
		const meshes = tree.levels.map((level, i) =>
			this.#level(`${name}_LOD${i}`, level, painter.level(level), { bark, leaves, barkBase }),
		);
		meshes.push(this.#impostor(`${name}_LOD3`, impostor));
		const hull = trunkHull(tree.skeleton);
		const collision = { shape: "cone", start: hull.start, end: hull.end, radii: hull.radii };
		const triangles = [
			...tree.levels.map(({ tubes, mesh }) => (tubes.mesh.indices.length + mesh.indices.length) / 3),
			crossedPictures(impostor).indices.length / 3,
		];
		const described = {
			name,
			link: this.about.link,
			levels: triangles.map((count, i) => ({ name: `${name}_LOD${i}`, triangles: count, screenCoverage: COVERAGE[i] })),
			wind: {
				attribute: this.windColours ? "COLOR_0" : "COLOR_1",
				channels: ["branch phase", "branch weight", "leaf phase", "visible sky"],
			},
			pivots: { attributes: ["TEXCOORD_1.xy", "TEXCOORD_2.x"], low: box.low, high: box.high },
			impostor: {
				colour: `${name}_Impostor.png`,
				surface: `${name}_Impostor_Surface.png`,
				layout: "hemi-octahedral",
				frames: FRAMES,
				framePixels: impostor.frame,
				middle: impostor.middle,
				radius: impostor.radius,
			},
			collision: { node: `UCX_${name}_00`, ...collision },
		};
		const nodes = meshes.map((mesh, i) => {
			const extras = i === 0 ? { collision, pivots: described.pivots, wind: described.wind } : undefined;
			return document.node({ name: `${name}_LOD${i}`, mesh, ...(extras ? { extras } : {}) });
		});
		const plain = document.material(gltfMaterial({ name: `${name}_Collision`, colour: GREY, roughness: 1 }, GREY, 0));
		const body = document.meshOf(`UCX_${name}_00`, [{ mesh: hull.mesh, material: plain }]);
		const collisionNode = document.node({ name: `UCX_${name}_00`, mesh: body });
		document.levels(nodes.slice(1), nodes[0], COVERAGE);
		const everything = { name: `${name}, all levels`, nodes: [...nodes, collisionNode] };
		const glb = document.finish([nodes[0]], { link: this.about.link, ...this.about.extras }, [everything]);
		return { glb, impostor, described };
	}

	/** Writes a material and its pictures. */
	#material(name: string, material: Material, base: [number, number, number] | undefined, pixels: number): number {
		const { colour, normal, repeats } = material.textures ?? {};
		const texture = (kind: string, picture: Picture | undefined, most: number) =>
			picture && this.#document.texture(`${name}_${kind}`, png(shrunk(picture, most)), repeats);
		const [colourIndex, normalIndex] = [texture("Colour", colour, pixels), texture("Normal", normal, NORMALS)];
		const factor = base ?? (colour ? [1, 1, 1] : material.colour);
		const textures = {
			...(colourIndex === undefined ? {} : { colour: colourIndex }),
			...(normalIndex === undefined ? {} : { normal: normalIndex }),
		};
		// Only values of the core of glTF, which every engine reads.
		const { name: _, sheet: __, ...plain } = material;
		return this.#document.material(gltfMaterial({ ...plain, name }, factor as [number, number, number], 0, textures));
	}

	/** Writes the mesh of a level: one draw call for wood and one for leaves. */
	#level(
		name: string,
		{ tubes, mesh }: CardLevel,
		wind: LevelWind,
		{ bark, leaves, barkBase }: { bark: number; leaves: number; barkBase: [number, number, number] },
	): number {
		const { windColours } = this;
		const primitives = [
			{ mesh: tubes.mesh, own: wind.wood, material: bark, base: barkBase, relief: this.tree.bark.textures?.normal },
			{ mesh, own: wind.leaves, material: leaves, base: [1, 1, 1] as [number, number, number], relief: undefined },
		].filter(({ mesh: { indices } }) => indices.length > 0);
		return this.#document.meshOf(
			name,
			primitives.map(({ mesh: each, own, material, base, relief }) => ({
				mesh: roundedMesh(each),
				tangents: relief && stepped(tangentsOf(each), NORMAL_STEPS),
				material,
				colours: windColours ? own.data : each.colours && sharesOf(each.colours, base),
				data: windColours ? undefined : own.data,
				furtherUvs: own.pivots,
			})),
		);
	}

	/** Writes the mesh of the last level: crossed pictures, for programs without a shader for impostors. */
	#impostor(name: string, impostor: Impostor): number {
		const index = this.#document.texture(`${this.name}_Impostor`, impostor.colourPng);
		const material: Material = {
			name: `${this.name}_Impostor`,
			colour: meanColour([1, 1, 1]),
			roughness: 1,
			doubleSided: true,
			cutout: true,
		};
		const written = this.#document.material(gltfMaterial(material, [1, 1, 1], 0, { colour: index }));
		return this.#document.meshOf(name, [{ mesh: crossedPictures(impostor), material: written }]);
	}
}

/** Returns the box around a level. */
function boxOf({ tubes, mesh }: CardLevel): PivotBox {
	const { low, high } = boundsOf([tubes.mesh.positions, mesh.positions]);
	return { low: low as Vector, high: high as Vector };
}

/** Returns a ball around a level. */
function ballOf(level: CardLevel): { middle: Vector; radius: number } {
	const { low, high } = boxOf(level);
	const middle = low.map((value, k) => 0.5 * (value + high[k])) as Vector;
	let radius = 0;
	for (const { positions } of [level.tubes.mesh, level.mesh])
		for (let i = 0; i < positions.length; i += 3)
			radius = Math.max(
				radius,
				Math.hypot(positions[i] - middle[0], positions[i + 1] - middle[1], positions[i + 2] - middle[2]),
			);
	return { middle, radius };
}

/** Returns the share of the sky that a segment sees: that of the leaves nearest to its end, about the brightness of its bark. */
function skyOf({ tubes: { mesh, segments } }: CardLevel): (segment: number) => number {
	const shares = new Map<number, number>();
	const { colours } = mesh;
	if (!colours) return () => 1;
	const most = brightest(colours);
	for (const [vertex, segment] of segments.entries()) shares.set(segment, Math.min(1, colours[3 * vertex] / most[0]));
	return (segment) => shares.get(segment) ?? 1;
}

/** Returns the triangles of a level as a canvas draws them; bark has the mean colour of its picture. */
function drawnLevel({ tubes, mesh }: CardLevel, { bark, leaves }: CardTree): Drawn[] {
	const picture = bark.textures?.colour;
	const { pixels } = picture ? linearPicture(shrunk(picture, 1)) : { pixels: [1, 1, 1] };
	const mean: [number, number, number] = [pixels[0], pixels[1], pixels[2]];
	const colour: [number, number, number] = tubes.mesh.colours ? mean : bark.colour;
	const atlas = leaves.textures?.colour;
	return [
		{ ...tubes.mesh, uvs: [], colour, doubleSided: false },
		{ ...mesh, colour: [1, 1, 1], picture: atlas && linearPicture(atlas), doubleSided: true },
	];
}

/** Rounds values to a number of steps per unit. */
const stepped = (values: Float32Array, steps: number) => values.map((value) => Math.round(value * steps) / steps);

/** Returns a mesh with positions and normals in steps, which pack better. */
function roundedMesh(mesh: PartMesh): PartMesh {
	return {
		...mesh,
		positions: stepped(mesh.positions, PLACE_STEPS),
		normals: stepped(mesh.normals, NORMAL_STEPS),
		uvs: stepped(mesh.uvs, 4096),
	};
}
