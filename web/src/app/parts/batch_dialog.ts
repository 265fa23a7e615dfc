import { html, nothing } from "lit";
import { MAX_IN_ARCHIVE } from "../../batch/series_zip";
import { Unusable } from "../../batch/unusable";
import { SEED } from "../../specimen/limits";
import { saveFile } from "../../ui/save_file";
import { type BatchRequest, batchFormats, filesOf, growBatch, seriesOf } from "../files/batch";
import { fileName } from "../files/formats";
import { downloadRequestFor, sizeInWords } from "../files/made_ahead";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import type { ShownPlant } from "../studio_state";
import type { BatchRows } from "./batch_rows";
import { StudioPart } from "./studio_part";
import "./batch_rows";

/** The largest number of the first plant: all numbers of the largest batch are seeds. */
const MAX_FIRST = SEED.max - MAX_IN_ARCHIVE + 1;

interface Making {
	readonly cancel: AbortController;
	readonly total: number;
	done: number;
}

/** The size of the file of the plant in view, in bytes. */
interface FileSize {
	readonly shown: ShownPlant;
	readonly format: string;
	readonly bytes: number;
}

/** The dialog that grows a batch of plants and downloads them as one archive. */
export class BatchDialog extends StudioPart {
	#batch: Omit<BatchRequest, "vary"> = { first: 1, count: 10, format: "glb" };
	#making: Making | undefined;
	#problem = "";
	#size: FileSize | undefined;
	/** Making of the file whose size is measured. */
	#measuring: AbortController | undefined;

	/** Renders the form of a batch: the number of plants, varied settings and format. */
	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		if (!shown) return nothing;
		const { first, count } = this.#batch;
		const format = this.#format(shown);
		return html`<dialog class="help many batch" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
			<h2 id=${this.idOf("title")}>${text("batch_title")}</h2>
			<p>${text("batch_about")}</p>
			<form @submit=${this.#submit}>
				<label>${text("batch_plants")} <input
					type="number" required min="1" max=${MAX_IN_ARCHIVE} step="1" .value=${String(count)} @input=${this.#number("count")}
				></label>
				<label>${text("batch_first")} <input
					type="number" required min="0" max=${MAX_FIRST} step="1" .value=${String(first)} aria-describedby=${this.idOf("first")} @input=${this.#number("first")}
				></label>
				<small id=${this.idOf("first")}>${text("batch_first_help")}</small>
				<panicle-batch-rows .context=${studio}></panicle-batch-rows>
				<label>${text("batch_files")} <select @change=${({ target }: Event) => this.#changeForm({ format: (target as HTMLSelectElement).value })}>
					${batchFormats(shown).map(({ key, title }) => html`<option value=${key} ?selected=${key === format}>${title}</option>`)}
				</select></label>
				<p class="summary">${this.#summary(shown, format)}</p>
				<p role="alert">${this.#problem}</p>
				${this.#making ? progress(this.#making) : nothing}
				<div class="choices">
					${
						this.#making
							? html`<button class="button" type="button" @click=${this.#cancel}>${text("cancel")}</button>`
							: html`<button class="button wine">${text("batch_grow")}</button>`
					}
					<button class="button quiet" type="button" @click=${this.#close}>${text("close")}</button>
				</div>
			</form>
		</dialog>`;
	}

	/** Opens the dialog; the browser traps the focus and restores it. */
	async open(): Promise<void> {
		await this.updateComplete;
		const dialog = this.querySelector("dialog");
		if (!dialog || dialog.open) return;
		dialog.showModal();
		await this.#rows?.refresh();
		await this.#measure();
	}

	/** The settings that vary. */
	get #rows(): BatchRows | null {
		return this.querySelector("panicle-batch-rows");
	}

	/** Returns the chosen format, or the first if the plant does not have the chosen one. */
	#format(shown: ShownPlant): string {
		const keys = batchFormats(shown).map(({ key }) => key);
		return keys.includes(this.#batch.format) ? this.#batch.format : keys[0];
	}

	/** Describes the number of files, and an estimate of their size from the file of the plant in view. */
	#summary(shown: ShownPlant, format: string): string {
		const { count } = this.#batch;
		const files = filesOf(this.#batch);
		const size = this.#size;
		if (size?.shown !== shown || size.format !== format) return text("batch_summary", { count, files });
		return text("batch_summary_size", { count, files, size: sizeInWords(size.bytes * count) });
	}

	/** Makes the file of the plant in view, to know its size. */
	async #measure(): Promise<void> {
		const { shown } = this.context.state;
		this.#measuring?.abort();
		if (!shown) return;
		const key = this.#format(shown);
		if (this.#size?.shown === shown && this.#size.format === key) return;
		const measuring = new AbortController();
		this.#measuring = measuring;
		const format = batchFormats(shown).find((each) => each.key === key);
		const request = await downloadRequestFor(shown, fileName(shown.from), {});
		// Without its size, the summary shows the number of files only.
		const file = await format?.make(request, measuring.signal).catch(() => undefined);
		if (!file || measuring.signal.aborted) return;
		this.#size = { shown, format: key, bytes: file.size };
		this.requestUpdate();
	}

	/** Returns a listener that takes a valid number from a field; the browser reports others. */
	#number(key: "first" | "count"): (event: Event) => void {
		return ({ target }) => {
			const { validity, valueAsNumber } = target as HTMLInputElement;
			if (validity.valid) this.#changeForm({ [key]: valueAsNumber });
		};
	}

	/** Changes the form; another format is measured again. */
	#changeForm(changed: Partial<BatchRequest>): void {
		this.#batch = { ...this.#batch, ...changed };
		this.#problem = "";
		this.requestUpdate();
		if (changed.format) void this.#measure();
	}

	/** Closes the dialog. */
	#close(): void {
		this.querySelector("dialog")?.close();
	}

	/** Ends all work after the dialog has been closed. */
	#closed(): void {
		this.#measuring?.abort();
		this.#cancel();
	}

	/** Cancels the batch that is being grown. */
	#cancel(): void {
		this.#making?.cancel.abort();
	}

	/** Begins to grow the batch. */
	#submit(event: SubmitEvent): void {
		event.preventDefault();
		if (!this.#making) void this.#grow();
	}

	/** Grows the plants of a batch and saves one ZIP; errors are shown in the dialog. */
	async #grow(): Promise<void> {
		const { state } = this.context;
		const vary = await this.#rows?.read();
		if (vary === undefined || !state.shown) return;
		const cancel = new AbortController();
		try {
			const { first, count } = this.#batch;
			const batch = seriesOf(state, { ...this.#batch, format: this.#format(state.shown), vary });
			const making: Making = { cancel, total: count, done: 0 };
			this.#measuring?.abort();
			this.#setProgress("", making);
			// The pressed button has disappeared: move the focus to the next one.
			await this.updateComplete;
			this.querySelector<HTMLElement>(".choices button")?.focus();
			const archive = await growBatch(batch, {
				signal: cancel.signal,
				progress: (done) => {
					making.done = done;
					this.requestUpdate();
				},
			});
			cancel.signal.throwIfAborted();
			saveFile(archive, `${batch.series.from.preset}-${first}-${first + count - 1}.zip`);
			this.#setProgress("", undefined);
			this.#close();
		} catch (error) {
			const problem = error instanceof Error ? error.message : String(error);
			const known = error instanceof Unusable;
			const line = known ? problem : text("batch_archive_failed", { problem });
			this.#setProgress(cancel.signal.aborted ? "" : line, undefined);
		}
	}

	/**
	 * Shows progress or a problem.
	 * @param making undefined where no batch is being grown
	 */
	#setProgress(problem: string, making: Making | undefined): void {
		this.#problem = problem;
		this.#making = making;
		this.requestUpdate();
	}
}

/** Renders the progress of a batch. */
function progress({ done, total }: Making): unknown {
	return html`<p role="status" class="progress">
		<progress aria-label=${text("batch_progress")} max=${total} value=${done}></progress> ${text("batch_done", { done, total })}
	</p>`;
}

customElements.define("panicle-batch", BatchDialog);
