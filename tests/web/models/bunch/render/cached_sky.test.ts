import { describe, expect, it } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { CachedSky } from "../../../../../web/src/models/bunch/render/cached_sky";

const RACHIS = 0;
const PEDICEL = 3;

interface Bunch {
	ids: number[];
	/** Two vertices a berry. */
	skies?: number[];
	kinds: number[];
	/** One vertex an internode. */
	stems?: number[];
}

/** Data of a bunch that the sky belongs to. */
function bunch({ ids, skies, kinds, stems }: Bunch): BunchPlant {
	return {
		berries: { count: ids.length, ids: Uint32Array.from(ids) },
		internodes: { count: kinds.length, kind: Uint32Array.from(kinds) },
		surfaces: { uvs: new Float32Array(4), ...(skies && { sky: Uint8Array.from(skies) }) },
		stem: { internode: Uint32Array.from(kinds.keys()), ...(stems && { sky: Uint8Array.from(stems) }) },
	} as unknown as BunchPlant;
}

const whole = bunch({ ids: [7, 9], skies: [10, 20, 30, 40], kinds: [RACHIS, PEDICEL, PEDICEL], stems: [200, 90, 60] });

describe("KeptSky", () => {
	it("leaves a bunch that has its sky, and one before any had, as they are", () => {
		const sky = new CachedSky();
		const preview = bunch({ ids: [1], kinds: [RACHIS] });
		expect(sky.of(preview)).toBe(preview);
		expect(sky.of(whole)).toBe(whole);
	});

	it("gives each berry of a preview its previous sky, by its id, and a new one the mean", () => {
		const sky = new CachedSky();
		sky.of(whole);
		const reused = sky.of(bunch({ ids: [9, 8, 7], kinds: [RACHIS] }));
		expect([...(reused.surfaces?.sky ?? [])]).toEqual([30, 40, 25, 25, 10, 20]);
	});

	it("gives stems the previous sky of their kind, in order, and further ones that of the last", () => {
		const sky = new CachedSky();
		sky.of(whole);
		const kinds = [PEDICEL, RACHIS, RACHIS, PEDICEL, PEDICEL];
		expect([...(sky.of(bunch({ ids: [7], kinds })).stem?.sky ?? [])]).toEqual([90, 200, 200, 60, 60]);
	});

	it("caches computed values, not reused ones", () => {
		const sky = new CachedSky();
		sky.of(whole);
		sky.of(bunch({ ids: [8], kinds: [RACHIS] }));
		expect([...(sky.of(bunch({ ids: [9], kinds: [RACHIS] })).surfaces?.sky ?? [])]).toEqual([30, 40]);
	});

	it("takes the mean where berries have other vertices", () => {
		const sky = new CachedSky();
		sky.of(whole);
		const other = bunch({ ids: [7], kinds: [RACHIS] });
		const surfaces = { ...other.surfaces, uvs: new Float32Array(6) };
		expect([...(sky.of({ ...other, surfaces } as BunchPlant).surfaces?.sky ?? [])]).toEqual([25, 25, 25]);
	});
});
