import { Vector3 } from "three";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { CameraController, EYE_HEIGHT } from "../../../web/src/render/camera_controller";
import { boundingProfileOf } from "../../../web/src/render/camera_fit";
import { sampleBunch } from "../models/bunch/sample_bunch";

const profile = (count: number, length: number) => {
	const bunch = sampleBunch(count, 1, length);
	return boundingProfileOf({ spheres: bunch.berries.spheres, points: bunch.internodes.ends });
};

/** The part of an element that OrbitControls uses. */
function element(): HTMLElement {
	const stub = {
		style: {},
		clientWidth: 800,
		clientHeight: 500,
		addEventListener: vi.fn(),
		removeEventListener: vi.fn(),
		getRootNode: () => stub,
		ownerDocument: { addEventListener: vi.fn(), removeEventListener: vi.fn() },
	};
	return stub as unknown as HTMLElement;
}

describe("CameraController", () => {
	let table: CameraController;
	let near: Vector3;
	const changed = vi.fn();
	beforeEach(() => {
		table = new CameraController(element(), true, changed);
		table.setAspect(1.6);
		table.follow(profile(90, 0.16), false);
		near = table.controls.target.clone().lerp(table.camera.position, 0.1);
		changed.mockClear();
	});
	afterEach(() => table.dispose());

	const pose = () => [...table.camera.position.toArray(), ...table.controls.target.toArray()];

	const expectPose = (expected: number[]) => {
		pose().forEach((value, k) => {
			expect(value).toBeCloseTo(expected[k], 9);
		});
	};

	it("looks at a tall plant from the height of a person's eyes over the ground, and never from below it", () => {
		const tall = boundingProfileOf({
			spheres: new Float32Array(0),
			points: Float32Array.of(-4, 3, 0, 4, 8, 1, 0, 3, 0, 0, 15, 0),
		});
		table.forget();
		table.setGround(3);
		table.follow(tall, false);
		expect(table.camera.position.y).toBeCloseTo(3 + EYE_HEIGHT, 1);
		table.orbit(0.3, -2);
		expect(table.camera.position.y).toBeGreaterThan(3);
		table.fit("front");
		expect(table.camera.position.y).toBeCloseTo(3 + EYE_HEIGHT, 1);
		table.setGround(undefined);
		table.fit();
		expect(table.camera.position.y).toBeGreaterThan(9);
	});

	it("looks at a small plant on the ground from a little above it", () => {
		const small = boundingProfileOf({ spheres: new Float32Array(0), points: Float32Array.of(0, 0, 0, 0.1, 0.4, 0) });
		table.forget();
		table.setGround(0);
		table.follow(small, false);
		const { position } = table.camera;
		expect(position.y).toBeLessThan(EYE_HEIGHT);
		expect(position.y).toBeGreaterThan(0.3);
	});

	it("measures the view's height at a depth: it grows with the distance, and none is behind the eye or among the plants", () => {
		const { camera } = table;
		const span = (point: Vector3) => table.spanAt(point.toArray());
		const centre = table.controls.target;
		const expected = 2 * table.distance * Math.tan((Math.PI * camera.fov) / 360);
		expect(span(centre)).toBeCloseTo(expected, 9);
		expect(span(near)).toBeCloseTo(0.9 * expected, 9);
		table.zoom(2);
		expect(span(centre)).toBeCloseTo(expected / 2, 9);
		expect(span(centre.clone().lerp(camera.position, 1.1))).toBeUndefined();
		table.look({ eye: [0, 1, 1], towards: [0, 1, 0] });
		expect(span(new Vector3(0, 1, 0))).toBeUndefined();
	});

	it("contains both plants in the depth range while gliding from a seedling to a tree a hundred times as tall, and back", () => {
		table.reducedMotion = false;
		const { camera } = table;
		const [small, large] = [profile(90, 0.16), profile(90, 16)];
		table.follow(large, false);
		table.advance(1000);
		table.advance(1160);
		const reach = table.controls.target.length() + 20;
		expect(camera.far).toBeGreaterThan(table.distance + reach);
		table.advance(2000);
		expect(camera.far).toBeGreaterThan(table.distance + reach);
		table.follow(small, false);
		table.advance(3000);
		table.advance(4000);
		expect(camera.near).toBeLessThan(0.5 * table.distance);
		expect(camera.far).toBeLessThan(20 * table.distance);
	});

	it("fits a tree that goes on growing during a glide", () => {
		table.reducedMotion = false;
		for (let i = 1; i <= 12; i++) {
			table.follow(profile(90, 0.16 * 1.2 ** i), false);
			table.advance(100 * i);
		}
		table.advance(2000);
		table.advance(4000);
		const { distance } = table;
		table.fit();
		expect(distance / table.distance).toBeCloseTo(1, 1);
	});

	it("glides, and stops gliding when reduced motion is switched on", () => {
		table.reducedMotion = false;
		const before = table.distance;
		table.follow(profile(90, 0.3), false);
		expect(table.advance(1000)).toBe(true);
		table.advance(1040);
		const under = table.distance;
		expect(under).toBeGreaterThan(before);
		expect(table.controls.enableDamping).toBe(true);
		table.reducedMotion = true;
		table.advance(1041);
		expect(table.advance(1042)).toBe(false);
		expect(table.distance).toBeGreaterThan(under * 1.05);
		expect(table.controls.enableDamping).toBe(false);
	});

	it("keeps a walking eye where it was placed, with the growing plant in the depth range", () => {
		table.look({ eye: [0, 1, 2], towards: [0, 1, 1] });
		const before = pose();
		table.zoom(2);
		table.pan(0.1, 0.1);
		table.orbit(0.5, 0.2);
		table.fit("side");
		expectPose(before);
		table.follow(profile(90, 200), false);
		expectPose(before);
		expect(table.camera.far).toBeGreaterThan(400);
		const far = table.camera.far;
		table.look({ eye: [0, 1, 1], towards: [0, 1, 0] });
		expect(table.camera.far).toBe(far);
		table.look(undefined);
		expect(table.distance).toBeGreaterThan(200);
	});

	it("does not move while a drag changes the bunch a little", () => {
		const before = pose();
		table.follow(profile(90, 0.165), false);
		table.advance(1000);
		expectPose(before);
	});

	it("moves away from a plant that outgrows the view while a control is held, and otherwise does not move", () => {
		const before = table.distance;
		table.follow(profile(90, 0.3), true);
		table.advance(1000);
		const { distance } = table;
		expect(distance).toBeGreaterThan(1.4 * before);
		table.follow(profile(90, 0.1), true);
		table.advance(2000);
		expect(table.distance).toBeCloseTo(distance, 9);
		table.follow(profile(90, 0.1), false);
		table.advance(3000);
		expect(table.distance).toBeLessThan(0.7 * distance);
	});

	it("keeps a plant that bends and grows completely in the picture while orbiting is off, and never comes nearer", () => {
		// Returns a stem of spheres of a given length that bends to the right by an angle.
		const stem = (length: number, degrees: number) => {
			const spheres: number[] = [];
			let [x, y] = [0, 0];
			for (let i = 0; i < 16; i++) {
				const angle = (degrees * i * Math.PI) / (180 * 16);
				x += (length / 16) * Math.sin(angle);
				y += (length / 16) * Math.cos(angle);
				spheres.push(x, y, 0, 0.002);
			}
			return {
				profile: boundingProfileOf({ spheres: Float32Array.from(spheres), points: new Float32Array(0) }),
				head: [x, y],
			};
		};
		table.setAspect(0.7);
		table.keepsWhole = true;
		table.controls.enabled = false;
		let { distance } = table;
		for (const [length, degrees] of [
			[0.2, 0],
			[0.2, 85],
			[0.5, -85],
			[0.1, 20],
			[0.4, 85],
		]) {
			const { profile: bent, head } = stem(length, degrees);
			table.follow(bent, true);
			table.advance(1000);
			table.advance(2000);
			const seen = new Vector3(head[0], head[1], 0).project(table.camera);
			expect(Math.max(Math.abs(seen.x), Math.abs(seen.y)), `${length} m, ${degrees}°`).toBeLessThan(1);
			expect(table.distance).toBeGreaterThan(0.999 * distance);
			distance = table.distance;
		}
		table.keepsWhole = false;
		table.follow(stem(0.1, 0).profile, false);
		table.advance(3000);
		expect(table.distance).toBeLessThan(0.7 * distance);
	});

	it("follows a bunch that has outgrown the view, but not while a handle in the scene is dragged", () => {
		const before = table.distance;
		table.controls.enabled = false;
		table.follow(profile(90, 0.3), true);
		table.advance(1000);
		expect(table.distance).toBeCloseTo(before, 9);
		table.controls.enabled = true;
		table.follow(profile(90, 0.3), false);
		expect(changed).toHaveBeenCalled();
		table.advance(2000);
		expect(table.distance).toBeGreaterThan(1.4 * before);
	});

	it("restores its position after a picture of another shape, with its orbit and zoom", () => {
		table.orbit(0.7, 0.5);
		table.zoom(1.7);
		table.follow(profile(90, 0.167), false);
		const before = pose();
		table.setAspect(0.5);
		table.setAspect(1.6);
		expectPose(before);
	});

	it("limits zooming and panning", () => {
		const { distance } = table;
		table.zoom(1e6);
		expect(table.distance).toBeGreaterThan(0.1 * distance);
		table.zoom(1e-6);
		expect(table.distance).toBeLessThan(10 * distance);
		for (let i = 0; i < 50; i++) table.pan(1, 1);
		table.fit();
		expect(table.distance).toBeCloseTo(distance, 6);
	});

	/** Position in the view of a point on the plant's near side: right, up. */
	const seen = () => {
		table.camera.updateMatrixWorld();
		return near.clone().project(table.camera);
	};

	it("turns the plant's near side to the right and down", () => {
		table.orbit(0.2, 0);
		expect(seen().x).toBeGreaterThan(0.02);
		expect(Math.abs(seen().y)).toBeLessThan(0.01);
		table.orbit(-0.2, 0.2);
		expect(Math.abs(seen().x)).toBeLessThan(1e-6);
		expect(seen().y).toBeLessThan(-0.02);
	});

	it("shifts the plant to the right and down, but never out of sight", () => {
		table.pan(0.05, 0.03);
		expect(seen().x).toBeGreaterThan(0.02);
		expect(seen().y).toBeLessThan(-0.02);
		const centre = new Vector3(...profile(90, 0.16).centre);
		for (let i = 0; i < 50; i++) table.pan(1, 1);
		const away = table.controls.target.distanceTo(centre);
		// Exactly as far as the plant extends from its middle.
		expect(away).toBeGreaterThan(0.05);
		expect(away).toBeLessThan(0.12);
	});

	it("fits a plant of another model at once, like the first one", () => {
		const first = table.distance;
		table.orbit(1, 0.4);
		table.forget();
		table.follow(profile(90, 0.3), true);
		const fitted = table.distance;
		expect(fitted).toBeGreaterThan(1.4 * first);
		table.advance(1000);
		expect(table.distance).toBeCloseTo(fitted, 9);
	});

	it("never turns over the top", () => {
		for (let i = 0; i < 100; i++) table.orbit(0.1, 0.3);
		expect(table.camera.position.clone().sub(table.controls.target).angleTo(table.camera.up)).toBeGreaterThan(0.1);
	});

	it("keeps the paper behind the bunch at any tilt", () => {
		table.orbit(0, 1.2);
		expect(table.paper - table.distance).toBeGreaterThan(0.08);
	});
});
