import { SphereGeometry, Vector3 } from "three";
import {
	type BerrySurfaces,
	type BunchPlant,
	type Fruit,
	TRAITS,
	type Trait,
} from "../../../../web/src/models/bunch/bunch_plant";
import { sampleBunch } from "./sample_bunch";

export interface PressedOptions extends Partial<Record<Trait, number>> {
	count?: number;
	seed?: number;
	fruit?: Fruit;
	/** Ratio of berry sizes to those that would just touch. */
	swell?: number;
	/** Length over width. */
	elongation?: number;
}

/** A natural bunch without botany: the sample's berries swollen and cut flat on the plane between neighbours. */
export function pressedBunch(options: PressedOptions = {}): BunchPlant {
	const {
		count = 120,
		seed = 1,
		fruit = "grape",
		swell = 1.3,
		elongation = 1,
		width: _,
		length: __,
		...traits
	} = options;
	const bunch = sampleBunch(count, seed, 0.13);
	const { berries } = bunch;
	const given = Object.entries(traits) as [Trait, number][];
	for (let i = 0; i < berries.count; i++) {
		berries.spheres[4 * i + 3] *= swell;
		const at = TRAITS.length * i;
		const width = (2 * berries.spheres[4 * i + 3]) / Math.cbrt(elongation);
		berries.traits.set([width, width * elongation], at);
		for (const [trait, value] of given) berries.traits[at + TRAITS.indexOf(trait)] = value;
	}
	const form = { fruit, taper: 0, blunt: 0, curve: 0 };
	return { ...bunch, procedure: "natural", form, surfaces: pressed(bunch) };
}

function pressed({ berries }: BunchPlant): BerrySurfaces {
	const pattern = new SphereGeometry(1, 24, 16);
	const { position, uv } = pattern.attributes;
	const size = position.count;
	const positions = new Float32Array(3 * size * berries.count);
	const normals = new Float32Array(positions.length);
	const rubbed = new Uint8Array(size * berries.count);
	const centre = (i: number) => new Vector3().fromArray(berries.spheres, 4 * i);
	for (let i = 0; i < berries.count; i++) {
		const axis = new Vector3().fromArray(berries.directions, 3 * i);
		const [width, length] = [0, 1].map((k) => 0.5 * berries.traits[TRAITS.length * i + k]);
		const here = centre(i);
		for (let v = 0; v < size; v++) {
			const at = i * size + v;
			const unit = turned(new Vector3().fromArray(position.array, 3 * v), axis);
			const along = axis.dot(unit);
			const free = unit
				.clone()
				.addScaledVector(axis, along * (length / width - 1))
				.multiplyScalar(width);
			const normal = unit
				.clone()
				.addScaledVector(axis, along * (width / length - 1))
				.normalize();
			for (let j = 0; j < berries.count; j++) {
				const other = centre(j).sub(here);
				const apart = other.length();
				if (j === i || apart > berries.spheres[4 * i + 3] + berries.spheres[4 * j + 3]) continue;
				const over =
					free.dot(other) / apart -
					(apart * berries.spheres[4 * i + 3]) / (berries.spheres[4 * i + 3] + berries.spheres[4 * j + 3]);
				if (over <= 0) continue;
				free.addScaledVector(other, -over / apart);
				normal.lerp(other.clone().normalize(), Math.min(1, (8 * over) / width)).normalize();
				rubbed[at] = 255;
			}
			free.add(here).toArray(positions, 3 * at);
			normal.toArray(normals, 3 * at);
		}
	}
	const uvs = Float32Array.from(uv.array);
	return { uvs, indices: Uint32Array.from(pattern.index?.array ?? []), positions, normals, pressed: rubbed };
}

/** The rotation from +Y to `axis`, the shortest way. */
function turned(v: Vector3, axis: Vector3): Vector3 {
	const up = new Vector3(0, 1, 0);
	const across = new Vector3().crossVectors(up, axis);
	const angle = Math.acos(Math.max(-1, Math.min(1, axis.y)));
	return across.lengthSq() > 1e-12
		? v.applyAxisAngle(across.normalize(), angle)
		: axis.y < 0
			? v.applyAxisAngle(new Vector3(1, 0, 0), Math.PI)
			: v;
}
