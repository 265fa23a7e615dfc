/**
 * A ring on the ground around the hovered or chosen plant: light between two dark lines, for contrast with soil and
 * leaves. It is faintly visible through objects in front of it.
 */
import {
	BufferAttribute,
	BufferGeometry,
	Color,
	DoubleSide,
	Group,
	Mesh,
	MeshBasicMaterial,
	type PerspectiveCamera,
	Vector3,
} from "three";
import { heightAt } from "../ground_grid";
import type { StandPlant } from "../stand_plant";

const PALE = "#fff4d6";
const DARK = "#2a211a";
/** Bands of the ring, in half widths from its centre line. */
const BANDS = [
	{ from: -1, to: -0.5, colour: DARK },
	{ from: -0.5, to: 0.5, colour: PALE },
	{ from: 0.5, to: 1, colour: DARK },
];
/** Number of vertices around each edge of a band. */
const ROUND = 72;
/** Half width and least radius, as shares of the view's height. */
const HALF_WIDTH = 0.0038;
const LEAST_RADIUS = 0.016;
/** Radius of the ring relative to the crown's. */
const CROWN_SHARE = 0.8;
/** Render order: after the ground and all plants. */
const ORDER = 9;

export class MarkRing {
	readonly object = new Group();
	readonly #geometry = new BufferGeometry();
	readonly #materials = [material(0.95, true), material(0.65, false)];
	#stand: StandPlant | undefined;
	#plant = 0;
	readonly #at = new Vector3();
	/** Camera position of the last build; a frame from the same position needs no work. */
	readonly #eye = new Vector3();
	#fov = 0;
	#isBuilt = false;

	/** Creates the bands' triangles and colours; positions are set when a plant is marked. */
	constructor() {
		const colours = BANDS.flatMap(({ colour }) => {
			const { r, g, b } = new Color(colour);
			return Array.from({ length: 2 * ROUND }, () => [r, g, b]).flat();
		});
		const indices = BANDS.flatMap((_, band) =>
			Array.from({ length: ROUND }, (__, i) => {
				const [a, b] = [2 * (ROUND * band + i), 2 * (ROUND * band + ((i + 1) % ROUND))];
				return [a, b, b + 1, a, b + 1, a + 1];
			}).flat(),
		);
		this.#geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
		this.#geometry.setAttribute("position", new BufferAttribute(new Float32Array(colours.length), 3));
		this.#geometry.setIndex(indices);
		for (const each of this.#materials) {
			const mesh = new Mesh(this.#geometry, each);
			mesh.renderOrder = ORDER;
			mesh.frustumCulled = false;
			this.object.add(mesh);
		}
		this.object.visible = false;
	}

	/** Shows the ring around a plant; hides it where undefined. */
	show(stand: StandPlant | undefined, plant: number | undefined): void {
		this.object.visible = stand !== undefined && plant !== undefined && plant < stand.places.count;
		if (!stand || plant === undefined || !this.object.visible) return;
		if (stand !== this.#stand || plant !== this.#plant) this.#isBuilt = false;
		this.#stand = stand;
		this.#plant = plant;
		this.#at.fromArray(stand.places.at, 3 * plant);
	}

	/** Rebuilds the ring for a camera, with a constant width on the screen. */
	aim(camera: PerspectiveCamera): void {
		if (!this.object.visible || !this.#stand) return;
		if (this.#isBuilt && camera.fov === this.#fov && camera.position.equals(this.#eye)) return;
		this.#isBuilt = true;
		this.#fov = camera.fov;
		this.#build(this.#stand, this.#eye.copy(camera.position));
	}

	/**
	 * Places the ring's vertices around the chosen plant on the ground, at least as large as can be seen from `eye`.
	 */
	#build(stand: StandPlant, eye: Vector3): void {
		const { places, kinds } = stand;
		// Height of the view at the plant's distance, metres.
		const viewHeight = 2 * this.#at.distanceTo(eye) * Math.tan((this.#fov * Math.PI) / 360);
		const crown = 0.5 * kinds[places.kind[this.#plant]].crown.width * places.scale[this.#plant];
		const radius = Math.max(CROWN_SHARE * crown, LEAST_RADIUS * viewHeight);
		// A hanging plant has no ground around it.
		const isOnGround = places.parent[this.#plant] < 0;
		const position = this.#geometry.getAttribute("position");
		let v = 0;
		for (const { from, to } of BANDS)
			for (let i = 0; i < ROUND; i++) {
				const angle = (2 * Math.PI * i) / ROUND;
				for (const offset of [from, to]) {
					const r = radius + offset * HALF_WIDTH * viewHeight;
					const [x, z] = [this.#at.x + r * Math.cos(angle), this.#at.z + r * Math.sin(angle)];
					const y = isOnGround ? heightAt(stand, x, z) : this.#at.y;
					position.setXYZ(v++, x, y + 0.5 * HALF_WIDTH * viewHeight, z);
				}
			}
		position.needsUpdate = true;
	}

	/** Removes the ring from the scene and releases its graphics memory. */
	dispose(): void {
		this.object.removeFromParent();
		this.#geometry.dispose();
		for (const each of this.#materials) each.dispose();
	}
}

/** Creates a ring's material. With `tested`, objects in front hide it; without, it is drawn over them. */
function material(opacity: number, tested: boolean): MeshBasicMaterial {
	return new MeshBasicMaterial({
		vertexColors: true,
		transparent: true,
		opacity,
		depthTest: tested,
		depthWrite: false,
		side: DoubleSide,
		toneMapped: false,
	});
}
