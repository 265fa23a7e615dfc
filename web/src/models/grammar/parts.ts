/** Splits a text's plant into parts: lines by colour, organs by kind and colour. */
import { linear } from "../../plant/colour";
import { type Material, standardMaterial } from "../../plant/material";
import { cut, type Part, type PartMesh, TRANSFORM } from "../../plant/part";
import type { MeshRun, PlantMesh } from "../../plant/plant";
import type { GrammarPlant } from "./grammar_plant";
import type { ColourKey } from "./parameters.generated";
import type { GrammarSpecimen } from "./specimen";

/** Above this number, organs of a kind have no names of their own, and files hold them in a few meshes. */
const MOST_NAMED = 300;
/** Above this number, polygons of one colour share a part, since each part is a draw call. */
const MOST_APART = 60;

export function* grammarParts(plant: GrammarPlant, { look }: GrammarSpecimen): Generator<Part> {
	const names = new Set<string>();
	const called = (name: string) => {
		for (let number = 1; ; number++) {
			const tried = number === 1 ? name : `${name} ${number}`;
			if (names.has(tried)) continue;
			names.add(tried);
			return tried;
		}
	};
	const dressed = new Map<string, Material>();
	const materialOf = (kind: string, colour: number) => {
		const known = dressed.get(`${kind} ${colour}`) ?? painted(kind, colour, look);
		dressed.set(`${kind} ${colour}`, known);
		return known;
	};
	for (const [index, mesh] of plant.meshes.entries()) {
		const colours = plant.runColours[mesh.name];
		if (!colours) {
			yield* instancedParts(plant, index, mesh, materialOf, called);
			continue;
		}
		for (const { name, colour, runs } of groupsOf(mesh, colours)) {
			const material = materialOf(mesh.material, colour);
			yield { name: called(name), shape: { mesh: gathered(mesh, runs), material } };
		}
	}
}

/** Groups the runs of a mesh: one group per run, or one per colour if there are many. */
function groupsOf({ runs }: PlantMesh, colours: Uint8Array): { name: string; colour: number; runs: MeshRun[] }[] {
	const shown = runs.map((run, place) => ({ run, colour: colours[place] })).filter(({ run }) => run.indexCount > 0);
	if (shown.length <= MOST_APART) return shown.map(({ run, colour }) => ({ name: run.name, colour, runs: [run] }));
	const groups = new Map<number, MeshRun[]>();
	for (const { run, colour } of shown) {
		const members = groups.get(colour) ?? [];
		groups.set(colour, members);
		members.push(run);
	}
	return [...groups].sort(([a], [b]) => a - b).map(([colour, members]) => ({ name: "Blades", colour, runs: members }));
}

/** Joins runs of a mesh into one mesh. */
function gathered(mesh: PlantMesh, runs: readonly MeshRun[]): PartMesh {
	if (runs.length === 1) return cut(mesh, runs[0]);
	const vertices = runs.reduce((sum, { vertexCount }) => sum + vertexCount, 0);
	const count = runs.reduce((sum, { indexCount }) => sum + indexCount, 0);
	const all = {
		positions: new Float32Array(3 * vertices),
		normals: new Float32Array(3 * vertices),
		uvs: new Float32Array(2 * vertices),
		indices: new Uint32Array(count),
		...(mesh.sky ? { sky: new Uint8Array(vertices) } : {}),
	};
	let [vertex, index] = [0, 0];
	for (const { firstVertex, vertexCount, firstIndex, indexCount } of runs) {
		const end = firstVertex + vertexCount;
		all.positions.set(mesh.positions.subarray(3 * firstVertex, 3 * end), 3 * vertex);
		all.normals.set(mesh.normals.subarray(3 * firstVertex, 3 * end), 3 * vertex);
		all.uvs.set(mesh.uvs.subarray(2 * firstVertex, 2 * end), 2 * vertex);
		if (mesh.sky) all.sky?.set(mesh.sky.subarray(firstVertex, end), vertex);
		for (let i = 0; i < indexCount; i++) all.indices[index + i] = mesh.indices[firstIndex + i] - firstVertex + vertex;
		vertex += vertexCount;
		index += indexCount;
	}
	return all;
}

/** Returns the material of a kind in a colour of the palette. */
function painted(kind: string, colour: number, look: GrammarSpecimen["look"]): Material {
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
	called: (name: string) => string,
): Generator<Part> {
	for (const [colour, members] of byColour(organs, organMarks, index)) {
		const transforms = gatheredTransforms(organs.transforms, members);
		const kind = titled(organs.tags[organs.tag[members[0]]] ?? mesh.name);
		const { sky } = organs;
		const each = (i: number) => ({
			name: `${kind} ${members[i] + 1}`,
			extras: { segment: organs.segment[members[i]], module: organMarks.module[members[i]] },
		});
		yield {
			name: called(`${kind} ${colour}`),
			shape: {
				mesh,
				material: materialOf(mesh.material, colour),
				instances: {
					transforms,
					...(organs.count > MOST_NAMED ? {} : { each }),
					...(sky ? { sky: members.length === organs.count ? sky : gatheredSky(sky, members) } : {}),
				},
			},
		};
	}
}

/**
 * Groups the organs of a mesh by colour. Plain loops, since there may be a hundred thousand at every step of a drag.
 */
function byColour(organs: GrammarPlant["organs"], { colour }: GrammarPlant["organMarks"], index: number) {
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

function gatheredTransforms(all: Float32Array, members: Uint32Array): Float32Array {
	if (TRANSFORM * members.length === all.length) return all;
	const transforms = new Float32Array(TRANSFORM * members.length);
	let at = 0;
	for (const member of members) for (let k = 0; k < TRANSFORM; k++) transforms[at++] = all[TRANSFORM * member + k];
	return transforms;
}

function gatheredSky(all: Uint8Array, members: Uint32Array): Uint8Array {
	const sky = new Uint8Array(members.length);
	for (let i = 0; i < members.length; i++) sky[i] = all[members[i]];
	return sky;
}

const titled = (name: string) => `${name.charAt(0).toUpperCase()}${name.slice(1)}`;
