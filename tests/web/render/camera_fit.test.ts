import fc from "fast-check";
import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { boundingProfileOf, fitView, needsRefit } from "../../../web/src/render/camera_fit";
import { evenly } from "../evenly";
import { sampleBunch } from "../models/bunch/sample_bunch";

const FOV = 24;
const NONE = new Float32Array(0);
const bunch = sampleBunch(90);
const profile = boundingProfileOf({ spheres: bunch.berries.spheres, points: bunch.internodes.ends });

/** The farthest any berry's centre comes from the middle of the view, as a share of half its height or width. */
function reach(distance: number, azimuth: number, elevation: number, aspect: number): number {
	const camera = new PerspectiveCamera(FOV, aspect, 0.001, 100);
	const target = new Vector3(...profile.centre);
	camera.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth).add(target);
	camera.lookAt(target);
	camera.updateMatrixWorld();
	let most = 0;
	for (let i = 0; i < bunch.berries.count; i++) {
		const at = new Vector3().fromArray(bunch.berries.spheres, 4 * i).project(camera);
		most = Math.max(most, Math.abs(at.x), Math.abs(at.y));
	}
	return most;
}

describe("fitView", () => {
	it("keeps every berry in view from all sides", () => {
		const aspect = evenly(0.4, 3);
		const azimuth = evenly(0, 6.3);
		const elevation = evenly(-1.4, 1.4);
		fc.assert(
			fc.property(aspect, azimuth, elevation, (ratio, turn, height) => {
				const { distance } = fitView(profile, (FOV * Math.PI) / 180, ratio, 0.07, height);
				expect(reach(distance, turn, height, ratio)).toBeLessThan(0.87);
			}),
		);
	});

	it("is no farther away than necessary", () => {
		const { distance } = fitView(profile, (FOV * Math.PI) / 180, 1.6, 0.07, 0);
		const reaches = Array.from({ length: 48 }, (_, k) => reach(distance, (k * Math.PI) / 24, 0, 1.6));
		expect(Math.max(...reaches)).toBeGreaterThan(0.75);
	});

	it("fits a crown of very many leaves by its outermost rings", () => {
		const count = 30_000;
		const spheres = new Float32Array(4 * count);
		for (let i = 0; i < count; i++) {
			const [up, turn, out] = [1 - (2 * (i + 0.5)) / count, 2.4 * i, 1 - 0.4 * ((i % 7) / 7)];
			const across = 5 * out * Math.sqrt(1 - up * up);
			spheres.set([across * Math.cos(turn), 6 + 5 * out * up, across * Math.sin(turn), 0.1], 4 * i);
		}
		const { centre, rings } = boundingProfileOf({ spheres, points: NONE });
		expect(rings.length / 3).toBeLessThan(500);
		expect(centre[1]).toBeCloseTo(6, 1);
		const whole = {
			centre,
			rings: Float32Array.from({ length: 3 * count }, (_, k) => {
				const [x, y, z, r] = spheres.subarray(4 * Math.floor(k / 3));
				return [Math.hypot(x - centre[0], z - centre[2]), y - centre[1], r][k % 3];
			}),
		};
		for (const elevation of [0, 0.5, 1.3]) {
			const [few, all] = [{ centre, rings }, whole].map((each) => fitView(each, 0.4, 1.6, 0.07, elevation));
			expect(few.distance / all.distance).toBeGreaterThan(0.995);
			expect(few.distance).toBeLessThanOrEqual(all.distance);
		}
		const flat = boundingProfileOf({
			spheres: spheres.map((value, i) => (i % 4 === 1 ? 2 : i % 4 === 3 ? 0 : value)),
			points: NONE,
		});
		expect(fitView(flat, 0.4, 1, 0.07, 0).distance).toBeGreaterThan(5);
	});

	it("fits an object without size, and the stems of a bunch without berries", () => {
		expect(fitView(boundingProfileOf({ spheres: NONE, points: NONE }), 0.4, 1, 0.07, 0).distance).toBeGreaterThan(0);
		const bare = fitView(boundingProfileOf({ spheres: NONE, points: bunch.internodes.ends }), 0.4, 1, 0.07, 0);
		expect(bare.distance).toBeGreaterThan(0.1);
		expect(Number.isFinite(bare.radius)).toBe(true);
	});
});

describe("needsRefit", () => {
	const fit = fitView(profile, 0.4, 1.6, 0.07, 0);
	it("ignores small changes of a drag", () => {
		expect(needsRefit(fit, { ...fit, distance: fit.distance * 1.05 })).toBe(false);
		expect(needsRefit(fit, { ...fit, distance: fit.distance * 0.85 })).toBe(false);
	});
	it("is true for a bunch that has outgrown, shrunk from or left the view", () => {
		expect(needsRefit(fit, { ...fit, distance: fit.distance * 1.2 })).toBe(true);
		expect(needsRefit(fit, { ...fit, distance: fit.distance * 0.6 })).toBe(true);
		expect(needsRefit(fit, { ...fit, target: [fit.radius, 0, 0] })).toBe(true);
	});
});
