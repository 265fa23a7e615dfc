import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { type BoundingProfile, fitView, hasOutgrown, needsRefit, showsWhole, type ViewFit } from "./camera_fit";

/** Field of view of a long lens, degrees: round objects look round at the view's edge. */
const FOV = 24;
const MARGIN = 0.07;
/** Initial direction of the camera, in degrees: slightly from the right and from above. */
const AZIMUTH = 24;
const ELEVATION = 7;
/** Field of view of a walker among plants, degrees, and distance of the near plane, metres. */
const WALKING_FOV = 58;
const WALKING_NEAR = 0.05;
/** Duration of the movement that follows an outgrown plant, ms. */
const EASE = 320;

/** Height of the eye over the ground outdoors, metres. */
export const EYE_HEIGHT = 1.7;
/** Steepest first view outdoors, degrees: the eye of small plants is lower. */
const STEEPEST = 14;
/** Least height of the eye over the ground, as a share of its distance. */
const LEAST_HEIGHT = 0.004;

export type ViewName = "three-quarter" | "front" | "side";

/** Position and target of the eye, metres. */
export interface Gaze {
	readonly eye: readonly [x: number, y: number, z: number];
	readonly towards: readonly [x: number, y: number, z: number];
}

const VIEWS: Record<ViewName, { azimuth: number; elevation: number }> = {
	"three-quarter": { azimuth: AZIMUTH, elevation: ELEVATION },
	front: { azimuth: 0, elevation: 0 },
	side: { azimuth: 90, elevation: 0 },
};

/** The camera, and the pointer controls that turn the plant in front of it. */
export class CameraController {
	readonly camera = new PerspectiveCamera(FOV, 1, 0.01, 10);
	readonly controls: OrbitControls;
	#fit: ViewFit | undefined;
	/** Profile of the plant shown, and the one that `#fit` is for. */
	#profile: BoundingProfile | undefined;
	#fitted: BoundingProfile | undefined;
	/** Elevation for which views are fitted: that of the last named view, so that turning the plant changes no fit. */
	#fitElevation = MathUtils.degToRad(ELEVATION);
	/** Elevation of the first view, degrees. */
	#firstElevation = ELEVATION;
	/**
	 * Whether the view follows a plant only to keep all of it in the picture: it moves away or sideways if the plant
	 * would leave the picture, even while pointers do not turn the plant, and never comes nearer.
	 */
	keepsWhole = false;
	/** Height of the ground, metres; undefined without ground. */
	#ground: number | undefined;
	/** Least elevation of the first view over the ground, degrees. */
	#leastElevation = -90;
	/** Whether the eye is placed by `look`, instead of orbiting the plant. */
	#walking = false;
	#glide: { from: Vector3; to: Vector3; fromDistance: number; toDistance: number; start: number } | undefined;

	/** @param changed called when the view has moved and must be drawn again */
	constructor(
		canvas: HTMLElement,
		/** Disables gliding and damping; may change at any time. */
		public reducedMotion: boolean,
		readonly changed: () => void,
	) {
		this.controls = new OrbitControls(this.camera, canvas);
		// Style sheets choose the cursor; the controls set it on the canvas itself.
		canvas.style.cursor = "";
		this.controls.dampingFactor = 0.12;
		this.controls.rotateSpeed = 0.85;
		this.controls.minPolarAngle = 0.12;
		this.controls.maxPolarAngle = Math.PI - 0.12;
		this.controls.addEventListener("change", () => {
			this.#keepInReach();
			this.#keepAboveGround();
			changed();
		});
		this.controls.addEventListener("start", () => {
			this.#glide = undefined;
		});
		this.#place(VIEWS["three-quarter"]);
	}

	/** Distance from the eye to its target, metres. */
	get distance(): number {
		return this.camera.position.distanceTo(this.controls.target);
	}

	/** Distance from the eye to the paper behind the plant, which does not touch the plant at any tilt. */
	get paper(): number {
		const { breadth, radius } = this.#fit ?? { breadth: 0.05, radius: 0.1 };
		const elevation = this.#elevation;
		return this.distance + 1.2 * (breadth * Math.cos(elevation) + radius * Math.abs(Math.sin(elevation)));
	}

	/**
	 * Elevation of the camera over the target's horizon, radians; negative below it. `phi` is the angle from straight up.
	 */
	get #elevation(): number {
		const arm = this.camera.position.clone().sub(this.controls.target);
		return Math.PI / 2 - new Spherical().setFromVector3(arm).phi;
	}

	/**
	 * Returns the height of the view at the depth of a point, metres; undefined for points behind the eye, and while the
	 * eye is placed by `look`, among the plants.
	 */
	spanAt(point: readonly [x: number, y: number, z: number]): number | undefined {
		if (this.#walking) return undefined;
		const depth = new Vector3(...point).sub(this.camera.position).dot(this.camera.getWorldDirection(new Vector3()));
		return depth > 0 ? 2 * depth * Math.tan(MathUtils.degToRad(this.camera.fov) / 2) : undefined;
	}

	/** Sets the view's aspect ratio (width / height). */
	setAspect(aspect: number): void {
		const before = this.#fit;
		this.camera.aspect = aspect;
		this.camera.updateProjectionMatrix();
		// After a change of aspect, the plant keeps its size relative to the view.
		if (this.#fitted && before && !this.#walking) {
			const zoom = this.distance / before.distance;
			this.#fit = this.#fitOf(this.#fitted);
			this.#setDistance(this.#fit.distance * zoom);
			this.#setLimits();
		}
	}

	/**
	 * Sets the plant shown. The view follows only if necessary, and glides. While a control is `held`, it only moves
	 * away from an outgrown plant; while a handle in the scene is dragged (orbiting is off), it does not move.
	 */
	follow(profile: BoundingProfile, held: boolean): void {
		this.#profile = profile;
		if (this.#walking) {
			this.#setWalkingDepth();
			return;
		}
		const now = this.#fitOf(profile);
		if (this.#fit === undefined) this.fit();
		else if (this.keepsWhole) this.#keepWhole(this.#fit, now);
		else if (held ? this.controls.enabled && hasOutgrown(this.#fit, now) : needsRefit(this.#fit, now))
			this.#glideTo(now);
	}

	/**
	 * Forgets the plant shown, because the next one is of another model: the view fits that one at once, without gliding.
	 * @param elevation of its first view, degrees above the horizon
	 */
	forget(elevation = ELEVATION): void {
		this.look(undefined);
		this.#firstElevation = elevation;
		this.#fit = undefined;
		this.#fitted = undefined;
		this.#profile = undefined;
		this.#ground = undefined;
		this.#glide = undefined;
	}

	/** Shows the whole plant, from the default view or a named one. */
	fit(view: ViewName = "three-quarter"): void {
		if (this.#walking) return;
		this.#glide = undefined;
		// Damping is off, else the rest of a fling would go on turning the plant.
		this.controls.enableDamping = false;
		this.controls.update();
		const elevation = this.#elevationOf(view);
		const from = { ...VIEWS[view], elevation };
		this.#place(from);
		this.#fitElevation = MathUtils.degToRad(elevation);
		if (this.#profile) {
			this.#fitted = this.#profile;
			this.#fit = this.#fitOf(this.#profile);
			this.controls.target.fromArray(this.#fit.target);
			this.#place(from);
			this.#setDistance(this.#fit.distance);
			this.#setLimits();
		}
		this.camera.lookAt(this.controls.target);
		this.changed();
	}

	/**
	 * Sets the height of the ground that the plant stands on, metres; undefined for none. The eye does not go below it,
	 * and the first view is from the height of a person's eyes.
	 * @param least least elevation of the first view, degrees; the eye is then higher
	 */
	setGround(level: number | undefined, least = -90): void {
		this.#leastElevation = least;
		if (level === this.#ground) return;
		this.#ground = level;
		this.#keepAboveGround();
	}

	/** Returns the elevation of a named view, degrees. */
	#elevationOf(view: ViewName): number {
		if (this.#ground === undefined || !this.#profile)
			return view === "three-quarter" ? this.#firstElevation : VIEWS[view].elevation;
		// The distance depends on the elevation, but hardly: two steps suffice.
		let elevation = 0;
		for (let i = 0; i < 2; i++) {
			const { target, distance } = fitView(
				this.#profile,
				MathUtils.degToRad(FOV),
				this.camera.aspect,
				MARGIN,
				MathUtils.degToRad(elevation),
			);
			const rise = (this.#ground + EYE_HEIGHT - target[1]) / distance;
			elevation = Math.min(STEEPEST, MathUtils.radToDeg(Math.asin(MathUtils.clamp(rise, -1, 1))));
		}
		return Math.max(this.#leastElevation, elevation);
	}

	/** Raises the eye on its sphere about the target to a little above the ground, if it is lower. */
	#keepAboveGround(): void {
		if (this.#ground === undefined || this.#walking) return;
		const arm = this.camera.position.clone().sub(this.controls.target);
		const distance = arm.length();
		const least = this.#ground + LEAST_HEIGHT * distance - this.controls.target.y;
		if (arm.y >= least || distance === 0) return;
		const angles = new Spherical().setFromVector3(arm);
		angles.phi = Math.acos(MathUtils.clamp(least / distance, -1, 1));
		this.camera.position.setFromSpherical(angles).add(this.controls.target);
		this.camera.lookAt(this.controls.target);
	}

	/** Places the eye at a position, where nothing else moves it; undefined shows the whole plant again. */
	look(from: Gaze | undefined): void {
		if (!from && !this.#walking) return;
		this.#walking = from !== undefined;
		this.camera.fov = from ? WALKING_FOV : FOV;
		if (!from) {
			this.camera.updateProjectionMatrix();
			this.fit();
			return;
		}
		this.#glide = undefined;
		this.controls.enableDamping = false;
		this.controls.minDistance = 0;
		this.controls.maxDistance = Infinity;
		this.controls.target.fromArray(from.towards);
		this.camera.position.fromArray(from.eye);
		this.camera.lookAt(this.controls.target);
		this.#setWalkingDepth();
		this.changed();
	}

	/** Turns the plant by angles in radians: to the right, and with its top towards the eye. */
	orbit(right: number, down: number): void {
		if (this.#walking) return;
		const arm = this.camera.position.clone().sub(this.controls.target);
		const angles = new Spherical().setFromVector3(arm);
		angles.theta -= right;
		angles.phi = MathUtils.clamp(angles.phi - down, this.controls.minPolarAngle, this.controls.maxPolarAngle);
		this.camera.position.setFromSpherical(angles).add(this.controls.target);
		this.#moved();
	}

	/** Scales the plant's apparent size by `factor`. */
	zoom(factor: number): void {
		if (this.#walking) return;
		const { minDistance, maxDistance } = this.controls;
		this.#setDistance(MathUtils.clamp(this.distance / factor, minDistance, maxDistance));
		this.#moved();
	}

	/** Shifts the plant by shares of the view's height: to the right and down. */
	pan(right: number, down: number): void {
		if (this.#walking) return;
		const span = 2 * this.distance * Math.tan(MathUtils.degToRad(FOV) / 2);
		const shift = new Vector3(-right * span, down * span, 0).applyQuaternion(this.camera.quaternion);
		this.controls.target.add(shift);
		this.camera.position.add(shift);
		this.#keepInReach();
		this.#moved();
	}

	/**
	 * Advances the view by one frame: moves a step along a glide, and lets the damping of the pointer controls act.
	 * @param now time stamp of the animation frame, ms
	 * @returns whether it is still moving
	 */
	advance(now: number): boolean {
		const glide = this.#glide;
		if (glide) {
			if (glide.start === 0) glide.start = now;
			const t = this.reducedMotion ? 1 : Math.min(1, (now - glide.start) / EASE);
			const eased = 1 - (1 - t) ** 3;
			const arm = this.camera.position.clone().sub(this.controls.target).normalize();
			this.controls.target.lerpVectors(glide.from, glide.to, eased);
			const distance = MathUtils.lerp(glide.fromDistance, glide.toDistance, eased);
			this.camera.position.copy(arm.multiplyScalar(distance).add(this.controls.target));
			if (t === 1) {
				this.#glide = undefined;
				this.#setLimits();
			}
		}
		this.controls.enableDamping = !this.reducedMotion;
		const moved = this.controls.update();
		this.camera.updateMatrixWorld();
		return moved || this.#glide !== undefined;
	}

	/** Ends the control of the camera and its listeners. */
	dispose(): void {
		this.controls.dispose();
	}

	/** Returns the view that fits a plant, with the camera's present lens. */
	#fitOf(profile: BoundingProfile): ViewFit {
		return fitView(profile, MathUtils.degToRad(FOV), this.camera.aspect, MARGIN, this.#fitElevation);
	}

	/**
	 * Glides back to a distance that shows all of the plant, if the plant extends beyond its view; else does nothing.
	 * @param shown the present view
	 * @param now the view that fits the plant as it is now
	 */
	#keepWhole(shown: ViewFit, now: ViewFit): void {
		const lens = { fov: MathUtils.degToRad(FOV), aspect: this.camera.aspect, elevation: this.#fitElevation };
		if (this.#profile && !showsWhole(shown, this.#profile, lens))
			this.#glideTo({ ...now, distance: Math.max(now.distance, shown.distance) });
	}

	/** Starts a glide to the view that fits a plant; the user's zoom relative to the fit stays. */
	#glideTo(fit: ViewFit): void {
		// During a glide, the zoom of its destination counts.
		const aimed = this.#glide?.toDistance ?? this.distance;
		const zoom = this.#fit ? aimed / this.#fit.distance : 1;
		this.#fit = fit;
		this.#fitted = this.#profile;
		this.controls.minDistance = 0;
		this.controls.maxDistance = Infinity;
		// During the glide both plants are within the depth range, even if one is a hundred times as large.
		this.#setDepth(Math.min(this.distance, fit.distance * zoom), Math.max(this.distance, fit.distance * zoom));
		this.#glide = {
			from: this.controls.target.clone(),
			to: new Vector3(...fit.target),
			fromDistance: this.distance,
			toDistance: fit.distance * zoom,
			start: 0,
		};
		this.changed();
	}

	/** Places the camera in a direction from the target, degrees, at a distance of 1. */
	#place({ azimuth, elevation }: { azimuth: number; elevation: number }): void {
		const angles = new Spherical(1, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
		this.camera.position.setFromSpherical(angles).add(this.controls.target);
	}

	/** Moves the camera along its line of sight to a distance from the target. */
	#setDistance(distance: number): void {
		const arm = this.camera.position.clone().sub(this.controls.target).setLength(distance);
		this.camera.position.copy(arm.add(this.controls.target));
	}

	/**
	 * Limits zooming to 0.25 to 4 times the fitted distance: from inside the outermost twigs to a plant as small as a
	 * stamp.
	 */
	#setLimits(): void {
		const fit = this.#fit;
		if (!fit) return;
		this.controls.minDistance = 0.25 * fit.distance;
		this.controls.maxDistance = 4 * fit.distance;
		this.#setDepth(fit.distance, fit.distance);
	}

	/** Sets the near and far planes for a range of distances between eye and target. */
	#setDepth(nearest: number, farthest: number): void {
		this.camera.near = 0.02 * nearest;
		this.camera.far = 10 * farthest;
		this.camera.updateProjectionMatrix();
	}

	/**
	 * Sets the depth range for a walking eye: the whole plant is visible from any position in it, however much it has
	 * grown.
	 */
	#setWalkingDepth(): void {
		this.camera.near = WALKING_NEAR;
		this.camera.far = Math.max(10, this.#profile ? 6 * this.#fitOf(this.#profile).radius : 0);
		this.camera.updateProjectionMatrix();
	}

	/** Limits panning: moves the target back into the plant's bounding sphere, and the camera with it. */
	#keepInReach(): void {
		const fit = this.#fit;
		if (!fit || this.#glide || this.#walking) return;
		const centre = new Vector3(...fit.target);
		const fromCentre = this.controls.target.clone().sub(centre);
		const excess = fromCentre.length() - fit.radius;
		if (excess <= 0) return;
		const correction = fromCentre.setLength(-excess);
		this.controls.target.add(correction);
		this.camera.position.add(correction);
	}

	/** Looks at the target from the camera's new position. */
	#moved(): void {
		this.#keepAboveGround();
		this.camera.lookAt(this.controls.target);
		this.changed();
	}
}
