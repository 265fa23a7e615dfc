/** A plant of this page from being opened on: the entry of the list that it makes. */
import type { PageModel } from "../../models/page_model";
import { withParameters } from "../../specimen/edit";
import { fromPreset } from "../../specimen/from_preset";
import { encodeLink } from "../../specimen/link";
import { sameSpecimen } from "../../specimen/same";
import type { Specimen } from "../../specimen/specimen";
import { runningBy } from "../panel_groups";
import { tidyName } from "../saved/saved";
import { extraOf } from "../session/stored_specimen";
import type { StudioState } from "../studio_state";
import { titleOf } from "../title";
import type { RecentPlant } from "./recent_plant";

type Shown = Pick<StudioState, "specimen" | "model" | "modelUi">;

export class Visit {
	/** An id that no other page of this browser has. */
	readonly id = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
	/** The link with which it was opened; undefined once its entry is stored. */
	from: Promise<string> | undefined;
	/** Whether its entry is older than its specimen. */
	isChanged = true;
	#specimen: Specimen;
	#model: PageModel;
	#title = "";
	#at = 0;
	#editedAt: number | undefined;
	#extra: RecentPlant["extra"];
	/** The link of its specimen, and the same once it is encoded. */
	#encoding: Promise<string>;
	#link: string | undefined;

	constructor(shown: Shown) {
		this.#specimen = shown.specimen;
		this.#model = shown.model;
		this.#encoding = this.#beginEncoding(shown);
		this.from = this.#encoding;
	}

	/** The specimen that is shown. */
	get specimen(): Specimen {
		return this.#specimen;
	}

	/** The model of the specimen. */
	get model(): PageModel {
		return this.#model;
	}

	/** The link of its specimen; rejects if it cannot be encoded. */
	get encoding(): Promise<string> {
		return this.#encoding;
	}

	/** Sets the specimen, which may come from Undo. */
	show(shown: Shown): void {
		if (isEdit(shown, this.#specimen)) this.#editedAt = Date.now();
		this.resume(shown);
	}

	/** Sets the specimen without an edit: the plant is shown again. */
	resume(shown: Shown): void {
		this.#specimen = shown.specimen;
		this.#model = shown.model;
		this.#encoding = this.#beginEncoding(shown);
	}

	/** Takes title and time of a specimen, and begins to encode its link, which it returns. */
	#beginEncoding({ specimen, model, modelUi }: Shown): Promise<string> {
		this.#title = tidyName(titleOf(specimen, model, modelUi?.tools)) || model.title;
		this.#at = Date.now();
		this.#link = undefined;
		this.isChanged = true;
		const encoding = encodeLink(model, specimen);
		encoding.then(
			(link) => {
				if (this.#specimen === specimen) this.#link = link;
			},
			() => {}, // Then the plant is not recorded.
		);
		return encoding;
	}

	/** Takes over the parts of the entry that the list has added. */
	stored({ editedAt, extra }: RecentPlant): void {
		this.from = undefined;
		this.#editedAt ??= editedAt;
		this.#extra = extra;
	}

	/** Returns the visit's entry of the list; undefined while its link is being encoded. */
	entry(): RecentPlant | undefined {
		const link = this.#link;
		if (link === undefined) return undefined;
		const isPreset = sameSpecimen(this.#specimen, fromPreset(this.#model, this.#specimen.preset));
		const hasExtra = extraOf(this.#model, this.#specimen) !== undefined;
		return {
			id: this.id,
			link,
			title: this.#title,
			at: this.#at,
			...(this.#editedAt === undefined || isPreset ? {} : { editedAt: this.#editedAt }),
			...(hasExtra ? { extra: this.#extra ?? "missing" } : {}),
		};
	}
}

/**
 * Returns whether the specimen differs from an earlier one by more than the parameters that a tool's bar animates.
 */
function isEdit({ specimen, model, modelUi }: Shown, before: Specimen): boolean {
	const running = runningBy(modelUi?.tools).map((key) => [key, specimen.parameters[key]] as const);
	return !sameSpecimen(specimen, withParameters(model, before, Object.fromEntries(running)));
}
