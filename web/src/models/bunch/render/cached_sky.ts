/**
 * Sky visibility of previews. During a drag the core does not compute sky visibility, a fifth of a step's time:
 * berries and stems reuse the last known values, which change little from step to step. The core computes them when
 * the drag pauses.
 */
import type { BerrySurfaces, BunchPlant, Internodes, SharedBerry, StemMesh } from "../bunch_plant";

/** Sky visibility of vertices without a counterpart in the previous bunch. */
const OPEN = 255;

export class CachedSky {
	#last: BunchPlant | undefined;

	/** Returns the bunch with the last known sky visibility; unchanged if none is known. */
	of(grown: BunchPlant): BunchPlant {
		if (!grown.stem || grown.stem.sky) {
			this.#last = grown;
			return grown;
		}
		const last = this.#last;
		if (!last?.stem?.sky) return grown;
		const { stem, berry, surfaces, foliage } = grown;
		return {
			...grown,
			stem: { ...stem, sky: skyOfStems(stem, grown.internodes, last.stem, last.stem.sky, last.internodes) },
			...(berry && { berry: { ...berry, sky: skyOfBerries(berry, grown, last) } }),
			...(surfaces && { surfaces: { ...surfaces, sky: skyOfBerries(surfaces, grown, last) } }),
			...(foliage && { foliage: { ...foliage, sky: skyOfLeaves(last.foliage?.sky, foliage.positions.length / 3) } }),
		};
	}
}

/**
 * Returns the sky visibility of the berries' vertices from the last berry of the same id; a new berry gets the mean.
 */
function skyOfBerries(surface: BerrySurfaces | SharedBerry, { berries }: BunchPlant, last: BunchPlant): Uint8Array {
	const verticesPerBerry = surface.uvs.length / 2;
	const before = (last.surfaces ?? last.berry)?.sky;
	const sky = new Uint8Array(verticesPerBerry * berries.count).fill(before ? meanSky(before) : OPEN);
	if (before?.length !== verticesPerBerry * last.berries.count) return sky;
	const berriesBefore = new Map(Array.from(last.berries.ids, (id, berry) => [id, berry]));
	berries.ids.forEach((id, berry) => {
		const berryBefore = berriesBefore.get(id);
		if (berryBefore !== undefined)
			sky.set(
				before.subarray(verticesPerBerry * berryBefore, verticesPerBerry * (berryBefore + 1)),
				verticesPerBerry * berry,
			);
	});
	return sky;
}

/**
 * Returns the sky visibility of the stems' vertices: each internode takes it from the last bunch's internode of the
 * same kind and rank among its kind, or from the last one of them.
 */
function skyOfStems(
	stem: StemMesh,
	internodes: Internodes,
	before: StemMesh,
	skyBefore: Uint8Array,
	internodesBefore: Internodes,
): Uint8Array {
	const sums = new Float64Array(internodesBefore.count);
	const counts = new Float64Array(internodesBefore.count);
	before.internode.forEach((internode, vertex) => {
		sums[internode] += skyBefore[vertex];
		counts[internode] += 1;
	});
	const byKindBefore = internodesByKind(internodesBefore);
	const skies = new Uint8Array(internodes.count);
	for (const [kind, members] of internodesByKind(internodes)) {
		const sameKind = byKindBefore.get(kind)?.filter((internode) => counts[internode] > 0) ?? [];
		members.forEach((internode, place) => {
			const internodeBefore = sameKind[Math.min(place, sameKind.length - 1)];
			skies[internode] =
				internodeBefore === undefined ? OPEN : Math.round(sums[internodeBefore] / counts[internodeBefore]);
		});
	}
	return Uint8Array.from(stem.internode, (internode) => skies[internode]);
}

/** Groups the indices of internodes by their kind. */
function internodesByKind({ kind }: Internodes): Map<number, number[]> {
	const members = new Map<number, number[]>();
	kind.forEach((each, internode) => {
		const list = members.get(each);
		if (list) list.push(internode);
		else members.set(each, [internode]);
	});
	return members;
}

/** Returns the sky visibility of the last foliage if it has as many vertices; otherwise its mean. */
function skyOfLeaves(before: Uint8Array | undefined, vertices: number): Uint8Array {
	if (before?.length === vertices) return before;
	return new Uint8Array(vertices).fill(before ? meanSky(before) : OPEN);
}

/** Returns the mean of sky visibilities, 0 … 255; all of the sky where there are none. */
function meanSky(values: Uint8Array): number {
	if (values.length === 0) return OPEN;
	return Math.round(values.reduce((sum, value) => sum + value, 0) / values.length);
}
