import type { PerspectiveCamera } from "three";
import type { Bodies } from "../../../scene/camera_fit";
import { CapsuleShadow } from "../../../scene/capsule_shadow";
import type { Figure, FigureStage, Ray } from "../../../scene/figure";
import { RecordTexture } from "../../../scene/record_texture";
import type { Grown } from "../grown";
import { tintOf } from "../parts/berry_tint";
import { bunchSkin } from "../parts/skin";
import { woodOf } from "../parts/stem_rules";
import type { BunchSpecimen as Specimen } from "../specimen";
import { meanOf } from "../traits";
import { berryMaterial, NONE, setSkin } from "./berry_material";
import { BunchSurface } from "./bunch_surface";
import { CAST_RECORD, Casters } from "./casters";
import { flowerMaterial } from "./flower_material";
import { foliageMaterial } from "./foliage_material";
import { pickBerry } from "./picking";
import { packReceivers, RECORD, type Receivers, receiverTexels } from "./receivers";
import { REHEARSAL, REHEARSAL_LOOK } from "./rehearsal";
import { capsulesOf } from "./shadow_capsules";
import { setStem, stemMaterial } from "./stem_material";

/** Of so many points of the foliage, one counts for the fit. */
const LEAF_POINTS = 8;

/** `stems` shows the stems without berries, withered pedicels marked (the paper's figure 14). */
export const BUNCH_MODES = ["whole", "stems"] as const;

/** A bunch with its berries' flesh, wax and shadows; `pick` and `mark` know berries by their ids. */
export class BunchFigure implements Figure<Pick<Specimen, "look">, Grown> {
	readonly modes = BUNCH_MODES;
	readonly #stage: FigureStage;
	readonly #receiverRecords = new RecordTexture(RECORD);
	readonly #casterRecords = new RecordTexture(CAST_RECORD);
	readonly #shared;
	readonly #surface: BunchSurface;
	readonly #shadow: CapsuleShadow;
	readonly #casters = new Casters();
	#grown: Grown | undefined;
	#receivers: Receivers | undefined;
	#mode: string = "whole";

	constructor(stage: FigureStage) {
		this.#stage = stage;
		this.#shared = {
			...stage.light.uniforms,
			receiverRecords: { value: this.#receiverRecords.texture },
			casterRecords: { value: this.#casterRecords.texture },
			berriesShown: { value: 1 },
		};
		this.#surface = new BunchSurface({
			berry: berryMaterial(this.#shared),
			stem: stemMaterial(this.#shared),
			flower: flowerMaterial(this.#shared),
			foliage: foliageMaterial(this.#shared),
		});
		this.#shadow = new CapsuleShadow(stage.shadow);
		stage.root.add(this.#surface.group);
	}

	rehearse(): void {
		this.show(REHEARSAL, { look: REHEARSAL_LOOK });
	}

	show(grown: Grown, { look }: Pick<Specimen, "look">): void {
		this.#grown = grown;
		this.mark(undefined);
		const { materials } = this.#surface;
		const skin = bunchSkin(grown, look);
		setSkin(materials.berry, skin);
		setStem(materials.stem, look.stem, woodOf(grown));
		materials.foliage.uniforms.autumn.value = meanOf(grown.berries, "shrivel", 0);
		const count = receiverTexels(grown) / RECORD;
		this.#receiverRecords.reserve(count);
		this.#casterRecords.reserve(count);
		this.#shared.receiverRecords.value = this.#receiverRecords.texture;
		this.#shared.casterRecords.value = this.#casterRecords.texture;
		this.#receivers = packReceivers(grown, (i) => tintOf(grown, i, skin), this.#receiverRecords.data);
		this.#receiverRecords.changed();
		this.#surface.show(grown);
		this.setMode(this.#mode);
	}

	bounds(): Bodies {
		const { berries, internodes, foliage } = this.#grown ?? REHEARSAL;
		if (!foliage) return { spheres: berries.spheres, points: internodes.ends };
		const leaves = foliage.positions.filter((_, i) => Math.floor(i / 3) % LEAF_POINTS === 0);
		const points = new Float32Array(internodes.ends.length + leaves.length);
		points.set(internodes.ends);
		points.set(leaves, internodes.ends.length);
		return { spheres: berries.spheres, points };
	}

	prepare(camera: PerspectiveCamera): void {
		if (!this.#receivers) return;
		const { key, rim, keyDirection, rimDirection } = this.#stage.light.uniforms;
		const keyLamp = { direction: keyDirection.value.toArray(), spread: key.value.spread };
		const rimLamp = { direction: rimDirection.value.toArray(), spread: rim.value.spread };
		const recast = this.#casters.cast(this.#receivers, keyLamp, rimLamp, this.#casterRecords.data);
		if (recast) this.#casterRecords.changed();
		this.#surface.sort(camera);
	}

	/** The berry nearest along the ray. Stems hide nothing. */
	pick(ray: Ray): number | undefined {
		if (!this.#grown || this.#mode !== "whole") return undefined;
		const { berries } = this.#grown;
		const index = pickBerry(berries, ray);
		return index === undefined ? undefined : berries.ids[index];
	}

	mark(id: number | undefined): void {
		const index = id === undefined ? NONE : (this.#grown?.berries.ids.indexOf(id) ?? NONE);
		this.#surface.materials.berry.uniforms.highlighted.value = index;
	}

	setMode(mode: string): void {
		this.#mode = mode;
		const whole = mode === "whole";
		this.#surface.berriesShown = whole;
		this.#shared.berriesShown.value = whole ? 1 : 0;
		this.#surface.materials.stem.uniforms.marking.value = whole ? 0 : 1;
		if (this.#grown) this.#shadow.lay(capsulesOf(this.#grown, whole));
	}

	dispose(): void {
		this.#surface.group.removeFromParent();
		this.#surface.dispose();
		this.#shadow.dispose();
		this.#receiverRecords.dispose();
		this.#casterRecords.dispose();
	}
}

/** The figure of bunches. */
export function bunchFigure(stage: FigureStage): BunchFigure {
	return new BunchFigure(stage);
}
