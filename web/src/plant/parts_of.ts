/** Parts of any plant, for models without parts of their own. */
import { type Material, standardMaterial } from "./material";
import { cut, type Part, TRANSFORM } from "./part";
import type { Organs, Plant, PlantMesh } from "./plant";

/**
 * Yields the parts of a plant's meshes. Each run of a mesh is a part; a mesh without runs is one part; a mesh of organs
 * is a group with one part per organ, named by the tags.
 * @param materials the model's own, by kind; others come from `standardMaterial`
 */
export function* partsOf(
	{ meshes, organs }: Pick<Plant, "meshes" | "organs">,
	materials: Readonly<Record<string, Material>> = {},
): Generator<Part> {
	const dressed = new Map<string, Material>();
	const names = new Names();
	for (const [index, mesh] of meshes.entries()) {
		const material = materials[mesh.material] ?? dressed.get(mesh.material) ?? standardMaterial(mesh.material);
		dressed.set(mesh.material, material);
		const attached = membersOf(organs, index);
		if (attached.length > 0) yield organsOf(organs, attached, mesh, material, names);
		else yield* runsOf(mesh, material, names);
	}
}

/** Yields the runs of a mesh with triangles as parts; a mesh without runs is one part. */
function* runsOf(mesh: PlantMesh, material: Material, names: Names): Generator<Part> {
	const runs = mesh.runs.filter(({ indexCount }) => indexCount > 0);
	if (mesh.indices.length === 0) return;
	if (runs.length === 0) yield { name: names.plain(mesh.name), shape: { mesh, material } };
	for (const run of runs) yield { name: names.plain(run.name), shape: { mesh: cut(mesh, run), material } };
}

/**
 * Returns organs that share a mesh as one part with an instance per organ.
 * @param members indices of the organs
 */
function organsOf(organs: Organs, members: number[], mesh: PlantMesh, material: Material, names: Names): Part {
	const transforms = new Float32Array(TRANSFORM * members.length);
	members.forEach((organ, i) => {
		transforms.set(organs.transforms.subarray(TRANSFORM * organ, TRANSFORM * (organ + 1)), TRANSFORM * i);
	});
	const called = members.map((organ) => names.numbered(organs.tags[organs.tag[organ]] ?? mesh.name));
	const each = (i: number) => ({ name: called[i], extras: { segment: organs.segment[members[i]] } });
	const sky = organs.sky && Uint8Array.from(members, (organ) => organs.sky?.[organ] ?? 255);
	const instances = { transforms, each, ...(sky ? { sky } : {}) };
	return { name: names.plain(mesh.name), shape: { mesh, material, instances } };
}

/**
 * Returns the indices of the organs that are drawn with a mesh.
 * @param mesh index of the mesh
 */
function membersOf({ count, mesh: meshOf }: Organs, mesh: number): number[] {
	return Array.from({ length: count }, (_, organ) => organ).filter((organ) => meshOf[organ] === mesh);
}

/** Unique names for an outliner. */
class Names {
	readonly #used = new Set<string>();
	readonly #numbers = new Map<string, number>();

	/** Returns the name, or a numbered one if it is used: `Trunk`; the second one `Trunk 2`. */
	plain(name: string): string {
		const title = titled(name);
		for (let number = 1; ; number++) {
			const tried = number === 1 ? title : `${title} ${number}`;
			if (!this.#used.has(tried)) return this.#take(tried);
		}
	}

	/** Returns the next numbered name, for names with many parts: `Leaf 001`, `Leaf 002` …. */
	numbered(name: string): string {
		const title = titled(name);
		const number = (this.#numbers.get(title) ?? 0) + 1;
		this.#numbers.set(title, number);
		const tried = `${title} ${String(number).padStart(3, "0")}`;
		return this.#used.has(tried) ? this.numbered(name) : this.#take(tried);
	}

	/** Marks a name as used, and returns it. */
	#take(name: string): string {
		this.#used.add(name);
		return name;
	}
}

/** Returns a name with a capital first letter. */
function titled(name: string): string {
	return name.charAt(0).toUpperCase() + name.slice(1);
}
