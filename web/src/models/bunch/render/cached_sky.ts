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
			stem: { ...stem, sky: ofStems(stem, grown.internodes, last.stem, last.stem.sky, last.internodes) },
			...(berry && { berry: { ...berry, sky: ofBerries(berry, grown, last) } }),
			...(surfaces && { surfaces: { ...surfaces, sky: ofBerries(surfaces, grown, last) } }),
			...(foliage && { foliage: { ...foliage, sky: fitting(last.foliage?.sky, foliage.positions.length / 3) } }),
		};
	}
}

/** Takes each berry's sky from the previous berry of its id; a new berry gets the mean. */
function ofBerries(surface: BerrySurfaces | SharedBerry, { berries }: BunchPlant, last: BunchPlant): Uint8Array {
	const each = surface.uvs.length / 2;
	const before = (last.surfaces ?? last.berry)?.sky;
	const sky = new Uint8Array(each * berries.count).fill(before ? mean(before) : OPEN);
	if (before?.length !== each * last.berries.count) return sky;
	const places = new Map(Array.from(last.berries.ids, (id, berry) => [id, berry]));
	berries.ids.forEach((id, berry) => {
		const was = places.get(id);
		if (was !== undefined) sky.set(before.subarray(each * was, each * (was + 1)), each * berry);
	});
	return sky;
}

/** Takes each internode's sky from the previous internode of its kind and its rank among them, or the last one's. */
function ofStems(
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
	const known = byKind(internodesBefore);
	const skies = new Uint8Array(internodes.count);
	for (const [kind, members] of byKind(internodes)) {
		const like = known.get(kind)?.filter((internode) => counts[internode] > 0) ?? [];
		members.forEach((internode, place) => {
			const was = like[Math.min(place, like.length - 1)];
			skies[internode] = was === undefined ? OPEN : Math.round(sums[was] / counts[was]);
		});
	}
	return Uint8Array.from(stem.internode, (internode) => skies[internode]);
}

function byKind({ kind }: Internodes): Map<number, number[]> {
	const members = new Map<number, number[]>();
	kind.forEach((each, internode) => {
		const list = members.get(each);
		if (list) list.push(internode);
		else members.set(each, [internode]);
	});
	return members;
}

/** Takes the sky of the previous mesh if it has as many vertices; otherwise its mean. */
function fitting(before: Uint8Array | undefined, vertices: number): Uint8Array {
	if (before?.length === vertices) return before;
	return new Uint8Array(vertices).fill(before ? mean(before) : OPEN);
}

function mean(values: Uint8Array): number {
	if (values.length === 0) return OPEN;
	return Math.round(values.reduce((sum, value) => sum + value, 0) / values.length);
}
