/** Splits a text's plant into parts: lines by colour, organs by kind and colour. */
import { linear } from "../../plant/colour";
import { type Material, standardMaterial } from "../../plant/material";
import { cut, type Part, type PartMesh, TRANSFORM } from "../../plant/part";
import type { MeshRun, PlantMesh } from "../../plant/plant";
import type { GrammarPlant } from "./grammar_plant";
import type { ColourKey } from "./parameters.generated";
import type { GrammarSpecimen } from "./specimen";

/** Above this number, organs of a kind have no names of their own, and files hold them in a few meshes. */
const MAX_NAMED = 300;
/** Above this number, polygons of one colour share a part, since each part is a draw call. */
const MAX_APART = 60;

/** Yields the parts of the plant, each mesh by colour, with names that are unique. */
export function* grammarParts(plant: GrammarPlant, { look }: GrammarSpecimen): Generator<Part> {
	const names = new Set<string>();
	const uniqueName = (name: string) => {
		for (let number = 1; ; number++) {
			const candidate = number === 1 ? name : `${name} ${number}`;
			if (names.has(candidate)) continue;
			names.add(candidate);
			return candidate;
		}
	};
	const materials = new Map<string, Material>();
	const materialOf = (kind: string, colour: number) => {
		const cached = materials.get(`${kind} ${colour}`) ?? paletteMaterial(kind, colour, look);
		materials.set(`${kind} ${colour}`, cached);
		return cached;
	};
	for (const [index, mesh] of plant.meshes.entries()) {
		const colours = plant.runColours[mesh.name];
		if (!colours) {
			yield* instancedParts(plant, index, mesh, materialOf, uniqueName);
			continue;
		}
		for (const { name, colour, runs } of groupsOf(mesh, colours)) {
			const material = materialOf(mesh.material, colour);
			yield { name: uniqueName(name), shape: { mesh: joinRuns(mesh, runs), material } };
		}
	}
}

/** Groups the runs of a mesh: one group per run, or one per colour if there are many. */
function groupsOf({ runs }: PlantMesh, colours: Uint8Array): { name: string; colour: number; runs: MeshRun[] }[] {
	const visible = runs.map((run, index) => ({ run, colour: colours[index] })).filter(({ run }) => run.indexCount > 0);
	if (visible.length <= MAX_APART) return visible.map(({ run, colour }) => ({ name: run.name, colour, runs: [run] }));
	const groups = new Map<number, MeshRun[]>();
	for (const { run, colour } of visible) {
		const members = groups.get(colour) ?? [];
		groups.set(colour, members);
		members.push(run);
	}
	return [...groups].sort(([a], [b]) => a - b).map(([colour, members]) => ({ name: "Blades", colour, runs: members }));
}

/** Joins runs of a mesh into one mesh. */
function joinRuns(mesh: PlantMesh, runs: readonly MeshRun[]): PartMesh {
	if (runs.length === 1) return cut(mesh, runs[0]);
	const vertices = runs.reduce((sum, { vertexCount }) => sum + vertexCount, 0);
	const count = runs.reduce((sum, { indexCount }) => sum + indexCount, 0);
	const joined = {
		positions: new Float32Array(3 * vertices),
		normals: new Float32Array(3 * vertices),
		uvs: new Float32Array(2 * vertices),
		indices: new Uint32Array(count),
		...(mesh.sky ? { sky: new Uint8Array(vertices) } : {}),
	};
	let [vertex, index] = [0, 0];
	for (const { firstVertex, vertexCount, firstIndex, indexCount } of runs) {
		const end = firstVertex + vertexCount;
		joined.positions.set(mesh.positions.subarray(3 * firstVertex, 3 * end), 3 * vertex);
		joined.normals.set(mesh.normals.subarray(3 * firstVertex, 3 * end), 3 * vertex);
		joined.uvs.set(mesh.uvs.subarray(2 * firstVertex, 2 * end), 2 * vertex);
		if (mesh.sky) joined.sky?.set(mesh.sky.subarray(firstVertex, end), vertex);
		for (let i = 0; i < indexCount; i++)
			joined.indices[index + i] = mesh.indices[firstIndex + i] - firstVertex + vertex;
		vertex += vertexCount;
		index += indexCount;
	}
	return joined;
}

/** Returns the material of a kind in a colour of the palette. */
function paletteMaterial(kind: string, colour: number, look: GrammarSpecimen["look"]): Material {
	const standard = standardMaterial(kind);
	const key = `colour${colour}` as ColourKey;
	return { ...standard, name: `${standard.name} ${colour}`, colour: linear(look[key]) };
}

/** Yields the organs that are instances of a mesh: a part for each colour. */
function* instancedParts(
	{ organs, organMarks }: GrammarPlant,
	index: number,
	mesh: PlantMesh,
	materialOf: (kind: string, colour: number) => Material,
	uniqueName: (name: string) => string,
): Generator<Part> {
	for (const [colour, members] of organsByColour(organs, organMarks, index)) {
		const transforms = gatheredTransforms(organs.transforms, members);
		const kind = capitalized(organs.tags[organs.tag[members[0]]] ?? mesh.name);
		const { sky } = organs;
		const nodeOf = (i: number) => ({
			name: `${kind} ${members[i] + 1}`,
			extras: { segment: organs.segment[members[i]], module: organMarks.module[members[i]] },
		});
		yield {
			name: uniqueName(`${kind} ${colour}`),
			shape: {
				mesh,
				material: materialOf(mesh.material, colour),
				instances: {
					transforms,
					...(organs.count > MAX_NAMED ? {} : { each: nodeOf }),
					...(sky ? { sky: members.length === organs.count ? sky : gatheredSky(sky, members) } : {}),
				},
			},
		};
	}
}

/**
 * Groups the organs of a mesh by colour, in the order of the palette. Plain loops, since there may be a hundred
 * thousand organs at every step of a drag.
 * @param index of the mesh
 */
function organsByColour(organs: GrammarPlant["organs"], { colour }: GrammarPlant["organMarks"], index: number) {
	const counts = new Map<number, number>();
	for (let organ = 0; organ < organs.count; organ++)
		if (organs.mesh[organ] === index) counts.set(colour[organ], (counts.get(colour[organ]) ?? 0) + 1);
	return [...counts]
		.sort(([a], [b]) => a - b)
		.map(([wanted, count]) => {
			const members = new Uint32Array(count);
			let at = 0;
			for (let organ = 0; organ < organs.count; organ++)
				if (organs.mesh[organ] === index && colour[organ] === wanted) members[at++] = organ;
			return [wanted, members] as const;
		});
}

/** Returns the transforms of some organs; `all` itself where all are members. */
function gatheredTransforms(all: Float32Array, members: Uint32Array): Float32Array {
	if (TRANSFORM * members.length === all.length) return all;
	const transforms = new Float32Array(TRANSFORM * members.length);
	let at = 0;
	for (const member of members) for (let k = 0; k < TRANSFORM; k++) transforms[at++] = all[TRANSFORM * member + k];
	return transforms;
}

/** Returns the sky visibilities of some organs. */
function gatheredSky(all: Uint8Array, members: Uint32Array): Uint8Array {
	const sky = new Uint8Array(members.length);
	for (let i = 0; i < members.length; i++) sky[i] = all[members[i]];
	return sky;
}

/** Capitalizes a name. */
const capitalized = (name: string) => `${name.charAt(0).toUpperCase()}${name.slice(1)}`;
