import { html, nothing } from "lit";
import { Unusable } from "../../batch/unusable";
import { saveFile } from "../../ui/save_file";
import { formatsOfMany, growMany, type Many, readMany } from "../files/many";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** The default number of plants. */
const FEW = 10;

interface Making {
	readonly cancel: AbortController;
	readonly total: number;
	done: number;
}

/** The dialog that grows a batch of plants and downloads them as one archive. */
export class ManyDialog extends StudioPart {
	#making: Making | undefined;
	#problem = "";

	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		if (!shown) return nothing;
		return html`<dialog class="help many" aria-labelledby=${this.idOf("title")} @close=${this.#cancel}>
			<h2 id=${this.idOf("title")}>Many in one ZIP</h2>
			<p>A file for each plant, each of a random seed, and a table: seeds, links, what was varied, what was measured.</p>
			<form @submit=${this.#submit}>
				<label>Plants <input name="numbers" required autocomplete="off" value="1-${FEW}"></label>
				<label>Vary <input name="vary" autocomplete="off" placeholder=${exampleFor(studio)} aria-describedby=${this.idOf("vary")}></label>
				<small id=${this.idOf("vary")}>Parameters by their keys in links: from one value to another, or one of a few (a|b); commas between several. Leave it empty to vary the seed only.</small>
				<label>Files <select name="format">${formatsOfMany(shown).map(({ key, title }) => html`<option value=${key}>${title}</option>`)}</select></label>
				<p role="alert">${this.#problem}</p>
				${this.#making ? progress(this.#making) : nothing}
				<div class="choices">
					${
						this.#making
							? html`<button class="button" type="button" @click=${this.#cancel}>Cancel</button>`
							: html`<button class="button wine">Grow them</button>`
					}
					<button class="button quiet" type="button" @click=${this.#close}>Close</button>
				</div>
			</form>
		</dialog>`;
	}

	/** Opens the dialog; the browser traps the focus and restores it. */
	async open(): Promise<void> {
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
	}

	#close(): void {
		this.querySelector("dialog")?.close();
	}

	#cancel(): void {
		this.#making?.cancel.abort();
	}

	#submit(event: SubmitEvent): void {
		event.preventDefault();
		const fields = new FormData(event.target as HTMLFormElement);
		const [numbers, vary, format] = ["numbers", "vary", "format"].map((name) => String(fields.get(name)));
		if (!this.#making) void this.#grow({ numbers, vary, format });
	}

	async #grow(many: Many): Promise<void> {
		const cancel = new AbortController();
		try {
			const series = readMany(this.context.state, many);
			const making: Making = { cancel, total: series.numbers.length, done: 0 };
			this.#setProgress("", making);
			// The pressed button has disappeared: move the focus to the next one.
			await this.updateComplete;
			this.querySelector<HTMLElement>(".choices button")?.focus();
			const archive = await growMany(series, {
				signal: cancel.signal,
				progress: (done) => {
					making.done = done;
					this.requestUpdate();
				},
			});
			cancel.signal.throwIfAborted();
			saveFile(archive, `${series.series.from.preset}-${many.numbers.replaceAll(/[^\d-]+/g, "_").slice(0, 60)}.zip`);
			this.#setProgress("", undefined);
			this.#close();
		} catch (error) {
			const known = error instanceof Unusable;
			const text = error instanceof Error ? error.message : String(error);
			this.#setProgress(
				cancel.signal.aborted ? "" : known ? `${text}.` : `The archive could not be made: ${text}`,
				undefined,
			);
		}
	}

	#setProgress(problem: string, making: Making | undefined): void {
		this.#problem = problem;
		this.#making = making;
		this.requestUpdate();
	}
}

/** An example for `--vary`: the middle half of the range of the first everyday parameter. */
function exampleFor({ state: { model } }: Studio): string {
	const everyday = model.table.groups.filter((group) => group.everyday).map(({ key }) => key);
	const entry = model.table.core.find(({ kind, group }) => kind !== "choice" && everyday.includes(group));
	if (!entry) return "";
	const at = (share: number) => Math.round(entry.min + share * (entry.max - entry.min));
	return `${entry.key}=${at(0.25)}..${at(0.75)}`;
}

function progress({ done, total }: Making): unknown {
	return html`<p role="status" class="progress">
		<progress aria-label="Growing the series" max=${total} value=${done}></progress> ${done} of ${total}
	</p>`;
}

customElements.define("panicle-many", ManyDialog);
