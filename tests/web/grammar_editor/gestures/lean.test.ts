/** Petrenko 2014, figure 47: the flower bends towards the circle, on the screen. */
import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { type Axis, atShare } from "../../../../web/src/grammar_editor/gestures/axis";
import { acrossScreen, toTheRight } from "../../../../web/src/grammar_editor/gestures/lean";

const BEND: Axis = { id: "constant bend", label: "bend", read: "0", min: -5, max: 5, step: 0.1, value: 0 };

/** Returns a camera that is turned around the plant by an angle, from the front to the right. */
function cameraAt(azimuth: number): PerspectiveCamera {
	const camera = new PerspectiveCamera();
	camera.position.setFromSphericalCoords(2, (83 * Math.PI) / 180, (azimuth * Math.PI) / 180);
	camera.lookAt(0, 0, 0);
	camera.updateMatrixWorld();
	return camera;
}

describe("a stem that bends towards the circle", () => {
	it("has its head at the circle on the screen, seen from any side", () => {
		for (const azimuth of [0, 24, 75, 110, 150, 180, -100, -30]) {
			const camera = cameraAt(azimuth);
			for (const circle of [0.1, 0.4, 0.7, 1]) {
				const bend = atShare(BEND, acrossScreen(circle, toTheRight(camera.matrixWorld)));
				const head = new Vector3(0.1 * bend, 0.5, 0).project(camera);
				expect(Math.sign(head.x), `azimuth ${azimuth}, circle ${circle}`).toBe(Math.sign(circle - 0.5));
			}
		}
	});

	it("does not move the circle when a drag begins", () => {
		for (const right of [-1, -0.2, 0.3, 1])
			for (const share of [0, 0.3, 1]) expect(acrossScreen(acrossScreen(share, right), right)).toBeCloseTo(share);
	});
});
