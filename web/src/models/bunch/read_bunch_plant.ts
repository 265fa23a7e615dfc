/** Converts an answer of the core to a bunch (columns: wasm-core/src/models/bunch/model.hpp). */
import type { Columns } from "../../core/container";
import type { Answer } from "../../core/core";
import type { MeshRun, Plant, PlantMesh } from "../../plant/plant";
import { readPlant, readSky } from "../../plant/read_plant";
import {
	type Berries,
	type BerrySurfaces,
	type BunchPlant,
	type Counts,
	type FlowerMesh,
	type FlowerPiece,
	type Foliage,
	type FoliagePart,
	FRUITS,
	type Internodes,
	type OwnProfile,
	type Plan,
	type PlanSide,
	type Procedure,
	type StemMesh,
	THINNED_WHY,
	type Thinned,
	TRAITS,
} from "./bunch_plant";
import { leafOnCane } from "./leaf";

/** Reads the answer of the core; surfaces, flowers and foliage where it has them. */
export function readBunchPlant(answer: Answer): BunchPlant {
	const { columns } = answer;
	const plant = readPlant(answer);
	const [taper, blunt, curve] = columns.floats("form");
	const grown: BunchPlant = {
		...plant,
		procedure: columns.text("procedure") as Procedure,
		form: { fruit: FRUITS[columns.uint32("fruit")[0]], taper, blunt, curve },
		plan: readPlan(columns, "plan"),
		counts: plant.counts as Counts,
		internodes: readInternodes(columns, plant),
		berries: readBerries(columns),
		thinned: readThinned(columns),
	};
	if (columns.has("profile")) grown.profile = readProfile(columns);
	if (columns.has("second.axes")) grown.second = readPlan(columns, "second");
	if (columns.has("berries.positions")) grown.surfaces = readSurfaces(columns);
	const mesh = (name: string) => plant.meshes.find((each) => each.name === name);
	const [stems, berry, flower, foliage] = ["stems", "berry", "flower", "foliage"].map(mesh);
	if (stems) grown.stem = readStem(columns, stems);
	if (berry) grown.berry = { ...berry, ...readSky(columns, "berries.") };
	if (flower) grown.flower = readFlower(columns, flower);
	if (foliage) grown.foliage = readFoliage(foliage);
	return grown;
}

/** Reads the profile of the bunch's seed, pixels. */
function readProfile(columns: Columns): OwnProfile {
	const [l, p3w, p3r, p4w, p4r, p5w, p5r, p6w, p6r] = columns.floats("profile");
	return { l, p3w, p3r, p4w, p4r, p5w, p5r, p6w, p6r };
}

/**
 * Reads a plan: four sides with their geometry (w, r) and counts, and the numbers of axes: m, then one for each rachis
 * segment.
 */
function readPlan(columns: Columns, name: string): Plan {
	const sides = columns.floats(`${name}.sides`);
	const counts = columns.ints(`${name}.counts`);
	const side = (i: number): PlanSide => ({
		w: sides[2 * i],
		r: sides[2 * i + 1],
		n: counts[2 * i],
		rd: counts[2 * i + 1],
	});
	const [m, ...axes] = columns.ints(`${name}.axes`);
	return { m, sides: [side(0), side(1), side(2), side(3)], axes };
}

/** Reads the skeleton: the segments that all plants have, with axis and state of each. */
function readInternodes(columns: Columns, { segments }: Plant): Internodes {
	const { count, parent, tag, ends, radii } = segments;
	const axis = columns.ints("segments.axis");
	return { count, parent, kind: tag, axis, state: columns.uint8("segments.state"), ends, radii };
}

/** Reads the berries; traits, a column each in the answer, are interleaved: TRAITS.length values per berry. */
function readBerries(columns: Columns): Berries {
	const parent = columns.ints("berries.parent");
	const traits = new Float32Array(parent.length * TRAITS.length);
	TRAITS.forEach((name, k) => {
		columns.floats(`berries.${name}`).forEach((value, berry) => {
			traits[berry * TRAITS.length + k] = value;
		});
	});
	return {
		count: parent.length,
		spheres: columns.floats("berries.spheres"),
		directions: columns.floats("berries.directions"),
		parent,
		ids: columns.uint32("berries.id"),
		traits,
	};
}

/** Reads the missing berries with reasons and places. */
function readThinned(columns: Columns): Thinned[] {
	const why = columns.uint32("thinned.why");
	const places = columns.floats("thinned.places");
	return Array.from(columns.uint32("thinned.id"), (id, index) => {
		const [x, y, z] = places.subarray(3 * index, 3 * index + 3);
		return { id, why: THINNED_WHY[why[index]], place: [x, y, z] };
	});
}

/** Reads deformed berries: all share one pattern of triangles and texture coordinates, and have their own positions. */
function readSurfaces(columns: Columns): BerrySurfaces {
	return {
		uvs: columns.floats("berries.pattern.uvs"),
		indices: columns.uint32("berries.pattern.indices"),
		positions: columns.floats("berries.positions"),
		normals: columns.floats("berries.normals"),
		pressed: columns.uint8("berries.pressed"),
		...readSky(columns, "berries."),
	};
}

/** Returns a run's ranges of vertices and indices, without its name. */
function rangeOf({ firstVertex, vertexCount, firstIndex, indexCount }: MeshRun) {
	return { firstVertex, vertexCount, firstIndex, indexCount };
}

/** Reads the mesh of the stems; each run of it belongs to one axis. */
function readStem(columns: Columns, { runs, name: _, material: _kind, ...mesh }: PlantMesh): StemMesh {
	const axis = columns.ints("mesh.stems.axis");
	const internode = columns.uint32("mesh.stems.segment");
	const parts = runs.map((run, index) => ({ axis: axis[index], ...rangeOf(run) }));
	return { ...mesh, internode, parts };
}

/** Reads the mesh of a flower; each run of it is a piece. */
function readFlower(columns: Columns, { runs, name: _, material: _kind, ...mesh }: PlantMesh): FlowerMesh {
	const pieces = runs.map((run) => ({ piece: run.name as FlowerPiece, ...rangeOf(run) }));
	return { ...mesh, pieces, unit: columns.floats("mesh.flower.unit")[0] };
}

/** Reads the mesh of cane and leaves, with the veins of the fetched leaf. */
function readFoliage({ runs, name: _, material: _kind, ...mesh }: PlantMesh): Foliage {
	const parts = runs.map((run) => ({ kind: run.name as FoliagePart["kind"], ...rangeOf(run) }));
	const veins = parts.some(({ kind }) => kind === "leaf") ? leafOnCane()?.veins : undefined;
	return { ...mesh, parts, ...(veins ? { veins } : {}) };
}
