import { type PerspectiveCamera, Scene, type WebGLRenderer } from "three";
import type { Grown } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { Backdrop } from "./backdrop";
import { berryMaterial, NONE, setSkin } from "./berry_material";
import { BunchSurface } from "./bunch_surface";
import { CastShadow } from "./cast_shadow";
import { CAST_RECORD, Casters } from "./casters";
import { flowerMaterial } from "./flower_material";
import { foliageMaterial } from "./foliage_material";
import { leafDiscs } from "./leaf_discs";
import { type LightRig, rigOf, spreadOf, type Theme } from "./light";
import { aimLamps, lightUniforms, setRig } from "./light_shader";
import { packReceivers, RECORD, type Receivers, receiverTexels } from "./receivers";
import { RecordTexture } from "./record_texture";
import { REHEARSAL, REHEARSAL_LOOK } from "./rehearsal";
import { berryTint, skinOf } from "./skin";
import { setStem, stemMaterial } from "./stem_material";
import { meanOf, traitOf } from "./traits";

/** The paper's berries know no sun: none stands out. */
const HALF = 0.5;
/** The paper's bunches have no age; theirs is a ripe one's wood. */
const PAPER_WOOD = 0.55;

export type Mode = "whole" | "stems";

/** The bunch, its light and the paper behind it: everything that is drawn, whatever it is drawn on. */
export class Stage {
	readonly scene = new Scene();
	readonly #light = lightUniforms();
	readonly #receiverRecords = new RecordTexture(RECORD);
	readonly #casterRecords = new RecordTexture(CAST_RECORD);
	readonly #shared = {
		...this.#light,
		receiverRecords: { value: this.#receiverRecords.texture },
		casterRecords: { value: this.#casterRecords.texture },
		berriesShown: { value: 1 },
	};
	readonly #surface = new BunchSurface({
		berry: berryMaterial(this.#shared),
		stem: stemMaterial(this.#shared),
		flower: flowerMaterial(this.#shared),
		foliage: foliageMaterial(this.#shared),
	});
	readonly #shadow = new CastShadow(this.#shared);
	readonly #backdrop = new Backdrop(this.#shadow.target.texture);
	readonly #casters = new Casters();
	#receivers: Receivers | undefined;
	#rig: LightRig = rigOf("light");
	#mode: Mode = "whole";
	#highlighted: number | undefined;

	constructor() {
		this.scene.add(this.#surface.group, this.#backdrop.mesh);
	}

	/**
	 * Draws the paper alone, and in passing has every program built, while the bunch is still growing.
	 * @param paper distance of the paper from the eye
	 */
	rehearse(renderer: WebGLRenderer, camera: PerspectiveCamera, paper: number): void {
		this.show(REHEARSAL, REHEARSAL_LOOK);
		this.draw(renderer, camera, paper);
		this.#receivers = undefined;
		this.#surface.group.visible = false;
	}

	/** Whether there is a bunch to draw. */
	get filled(): boolean {
		return this.#receivers !== undefined;
	}

	show(grown: Grown, look: Look): void {
		this.highlighted = undefined;
		const { berries } = grown;
		const { materials } = this.#surface;
		const paper = grown.procedure === "paper";
		const skin = skinOf(look, grown.form.fruit, paper);
		setSkin(materials.berry, skin);
		setStem(materials.stem, look.stem, woodOf(grown));
		materials.foliage.uniforms.autumn.value = meanOf(berries, "shrivel", 0);
		const discs = grown.foliage && leafDiscs(grown.foliage);
		const count = receiverTexels(grown, discs) / RECORD;
		this.#receiverRecords.reserve(count);
		this.#casterRecords.reserve(count);
		this.#shared.receiverRecords.value = this.#receiverRecords.texture;
		this.#shared.casterRecords.value = this.#casterRecords.texture;
		const tint = (i: number) =>
			berryTint(skin, berries.ids[i], {
				exposure: paper ? HALF : traitOf(berries, i, "exposure"),
				set: traitOf(berries, i, "set"),
				shrivel: traitOf(berries, i, "shrivel"),
			});
		this.#receivers = packReceivers(grown, tint, this.#receiverRecords.data, discs);
		this.#receiverRecords.changed();
		this.#surface.show(grown);
		this.#surface.group.visible = true;
		this.#showBerries();
	}

	/** The berry pointed at, by index. */
	get highlighted(): number | undefined {
		return this.#highlighted;
	}

	set highlighted(berry: number | undefined) {
		this.#highlighted = berry;
		this.#surface.materials.berry.uniforms.highlighted.value = berry ?? NONE;
	}

	get mode(): Mode {
		return this.#mode;
	}

	set mode(mode: Mode) {
		this.#mode = mode;
		this.#showBerries();
	}

	set theme(theme: Theme) {
		this.#rig = rigOf(theme);
		setRig(this.#light, this.#rig);
		this.#backdrop.setRig(this.#rig);
		this.#shadow.setLamp(this.#rig.shadow.direction, spreadOf(this.#rig.key));
	}

	/**
	 * Draws everything. What depends on where the viewer stands (shadows, order) is settled here.
	 * @param paper distance of the paper from the eye
	 */
	draw(renderer: WebGLRenderer, camera: PerspectiveCamera, paper: number): void {
		this.#backdrop.setAspect(camera.aspect);
		if (this.#receivers) {
			aimLamps(this.#light, this.#rig, camera.matrixWorld);
			const { key, rim, keyDirection, rimDirection } = this.#light;
			const keyLamp = { direction: keyDirection.value.toArray(), spread: key.value.spread };
			const rimLamp = { direction: rimDirection.value.toArray(), spread: rim.value.spread };
			this.#casters.cast(this.#receivers, keyLamp, rimLamp, this.#casterRecords.data);
			this.#casterRecords.changed();
			this.#surface.sort(camera);
			this.#shadow.draw(renderer, camera, this.#receivers, paper, this.#mode === "whole");
		}
		renderer.render(this.scene, camera);
	}

	dispose(): void {
		this.#surface.dispose();
		this.#backdrop.dispose();
		this.#shadow.dispose();
		this.#receiverRecords.dispose();
		this.#casterRecords.dispose();
	}

	#showBerries(): void {
		const shown = this.#mode === "whole";
		this.#surface.berriesShown = shown;
		this.#shared.berriesShown.value = shown ? 1 : 0;
		this.#surface.materials.stem.uniforms.marking.value = shown ? 0 : 1;
	}
}

/** How far a bunch's stems have turned woody, 0 … 1: they do as the berries colour, and go on as these dry. */
function woodOf({ berries, procedure }: Grown): number {
	if (procedure === "paper") return PAPER_WOOD;
	return 0.55 * meanOf(berries, "turned", 1) + 0.45 * meanOf(berries, "shrivel", 0);
}
