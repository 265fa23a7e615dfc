import type { PerspectiveCamera } from "three";
import { type Sway, swayOf } from "../../../plant/sway";
import type { Bodies } from "../../../render/camera_fit";
import { CapsuleShadow } from "../../../render/capsule_shadow";
import type { ModelRenderer, RendererStage, ViewRay } from "../../../render/model_renderer";
import { RecordTexture } from "../../../render/record_texture";
import { StandardLights } from "../../../render/standard_lights";
import { standardMaterial } from "../../../render/standard_material";
import type { BunchPlant } from "../bunch_plant";
import { tintOf } from "../parts/berry_tint";
import { FLOWERS, foliageMaterials, stemMaterial } from "../parts/materials";
import { type BunchDress, bunchSkin } from "../parts/skin";
import { berryMaterial, NONE, setSkin } from "./berry_material";
import { BunchSurface, type PartMaterials } from "./bunch_surface";
import { CachedSky } from "./cached_sky";
import { CAST_RECORD, Casters } from "./casters";
import { LAMP_CHUNK } from "./lamp_shader";
import { pickBerry } from "./picking";
import { type Receivers, receiversOf } from "./receivers";
import { capsulesOf } from "./shadow_capsules";
import { WARM_UP_BUNCH, WARM_UP_LOOK } from "./warm_up";

/** One of this many points of the foliage counts for the camera fit. */
const LEAF_POINTS = 8;

/** Shader chunks that find a vertex's receiver: of stems its internode, of flowers their berry. */
const OF_STEM =
	"attribute uint internode;\nuniform int firstInternode;\nvec2 lamp_shares(vec3 point) { return shares_of(firstInternode + int(internode), point); }";
const OF_FLOWER =
	"attribute float ownerBerry;\nvec2 lamp_shares(vec3 point) { return shares_of(int(ownerBerry), point); }";

/** Display modes: `stems` shows the stems without berries, with withered pedicels marked (the paper's figure 14). */
export const BUNCH_MODES = ["whole", "stems"] as const;

/** Renders a bunch with its berries' flesh, wax and shadows; `pick` and `mark` use berry ids. */
export class BunchRenderer implements ModelRenderer<BunchDress, BunchPlant> {
	readonly modes = BUNCH_MODES;
	readonly #stage: RendererStage;
	readonly #casterRecords = new RecordTexture(CAST_RECORD);
	readonly #shared;
	readonly #firstInternode = { value: 0 };
	readonly #surface: BunchSurface;
	readonly #lights = new StandardLights();
	readonly #shadow: CapsuleShadow;
	readonly #casters = new Casters();
	readonly #sky = new CachedSky();
	#grown: BunchPlant | undefined;
	#receivers: Receivers | undefined;
	#mode: string = "whole";

	/** @param stage light, wind and the scene's root, which receives the bunch */
	constructor(stage: RendererStage) {
		this.#stage = stage;
		this.#shared = {
			...stage.light.uniforms,
			...stage.wind,
			casterRecords: { value: this.#casterRecords.texture },
			berriesShown: { value: 1 },
		};
		this.#surface = new BunchSurface(this.#materials());
		this.#shadow = new CapsuleShadow(stage.shadow, stage.wind);
		stage.root.add(this.#surface.group, this.#lights.group);
	}

	/** Creates the materials of a bunch; berries cast shadows on stems and flowers through shared uniforms. */
	#materials(): PartMaterials {
		const light = this.#stage.light.uniforms;
		const { casterRecords, berriesShown } = this.#shared;
		const firstInternode = this.#firstInternode;
		const { cane, leaf, petiole } = foliageMaterials(0);
		const lit = { light, coloured: true, sky: true, wind: this.#stage.wind };
		const shares = (chunk: string) => ({
			chunk: LAMP_CHUNK + chunk,
			uniforms: { casterRecords, berriesShown, firstInternode },
		});
		return {
			berry: berryMaterial(this.#shared),
			stem: standardMaterial(stemMaterial([1, 1, 1]), { ...lit, shares: shares(OF_STEM) }),
			flower: standardMaterial(FLOWERS, { ...lit, shares: shares(OF_FLOWER) }),
			foliage: {
				cane: standardMaterial(cane, lit),
				leaf: standardMaterial(leaf, lit),
				petiole: standardMaterial(petiole, lit),
			},
		};
	}

	/** Draws an invisible bunch, which compiles the shader programs. */
	warmUp(): void {
		this.show(WARM_UP_BUNCH, { look: WARM_UP_LOOK });
	}

	/**
	 * Replaces the drawn bunch. Shadows between berries are computed by `prepare`, when the light's direction is known.
	 */
	show(latest: BunchPlant, dress: BunchDress): void {
		const { look } = dress;
		const grown = this.#sky.of(latest);
		this.#grown = grown;
		this.mark(undefined);
		const skin = bunchSkin(grown, dress);
		setSkin(this.#surface.materials.berry, skin);
		this.#firstInternode.value = grown.berries.count;
		this.#receivers = receiversOf(grown);
		this.#casterRecords.reserve(this.#receivers.count);
		this.#shared.casterRecords.value = this.#casterRecords.texture;
		this.#surface.show(grown, look, (i) => tintOf(grown, i, skin));
		this.setMode(this.#mode);
	}

	/** Returns the bounds of the drawn bunch; of the foliage only some points. */
	bounds(): Bodies {
		const { berries, internodes, foliage } = this.#grown ?? WARM_UP_BUNCH;
		if (!foliage) return { spheres: berries.spheres, points: internodes.ends };
		const leaves = foliage.positions.filter((_, i) => Math.floor(i / 3) % LEAF_POINTS === 0);
		const points = new Float32Array(internodes.ends.length + leaves.length);
		points.set(internodes.ends);
		points.set(leaves, internodes.ends.length);
		return { spheres: berries.spheres, points };
	}

	/** Returns the movement in the wind; undefined before the first bunch. */
	sway(): Sway | undefined {
		return this.#grown && swayOf(this.#grown);
	}

	/** Prepares a frame: aims the lamps, computes shadows again if the light has turned, and sorts by the camera. */
	prepare(camera: PerspectiveCamera): void {
		this.#lights.aim(this.#stage.light, camera, this.#stage.wind);
		if (!this.#receivers) return;
		const { key, rim, keyDirection, rimDirection } = this.#stage.light.uniforms;
		const keyLamp = { direction: keyDirection.value.toArray(), spread: key.value.spread };
		const rimLamp = { direction: rimDirection.value.toArray(), spread: rim.value.spread };
		const recast = this.#casters.cast(this.#receivers, keyLamp, rimLamp, this.#casterRecords.data);
		if (recast) this.#casterRecords.changed();
		this.#surface.sort(camera);
	}

	/** Returns the id of the nearest berry along a ray. Stems do not occlude. */
	pick(ray: ViewRay): number | undefined {
		if (!this.#grown || this.#mode !== "whole") return undefined;
		const { berries } = this.#grown;
		const index = pickBerry(berries, ray);
		return index === undefined ? undefined : berries.ids[index];
	}

	/** Highlights the berry of an id; undefined ends the highlight. */
	mark(id: number | undefined): void {
		const index = id === undefined ? NONE : (this.#grown?.berries.ids.indexOf(id) ?? NONE);
		this.#surface.materials.berry.uniforms.highlighted.value = index;
	}

	/** Shows the whole bunch or the stems alone. */
	setMode(mode: string): void {
		this.#mode = mode;
		const whole = mode === "whole";
		this.#surface.bare = !whole;
		this.#shared.berriesShown.value = whole ? 1 : 0;
		if (this.#grown) this.#shadow.set(capsulesOf(this.#grown, whole));
	}

	/** Removes the bunch from the scene and releases its graphics memory. */
	dispose(): void {
		this.#surface.group.removeFromParent();
		this.#surface.dispose();
		this.#lights.dispose();
		this.#shadow.dispose();
		this.#casterRecords.dispose();
	}
}

/** Creates the renderer of bunches. */
export function bunchRenderer(stage: RendererStage): BunchRenderer {
	return new BunchRenderer(stage);
}
