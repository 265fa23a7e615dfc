import { html, nothing, type TemplateResult } from "lit";
import { encodeLink } from "../../specimen/link";
import { chooseFile } from "../../ui/choose_file";
import { saveFile } from "../../ui/save_file";
import { formatCount } from "../../ui/thousands";
import { notInLink } from "../address";
import type { LibraryStep } from "../saved/library";
import { type Brought, broughtInWords, readLibrary, writeLibrary } from "../saved/library_file";
import { openSaved, savedOf } from "../saved/on_screen";
import { ownLibrary, requestPersistence } from "../saved/own_library";
import { LONGEST_NAME, type Saved, tidyName, uniqueName } from "../saved/saved";
import type { Studio } from "../studio";
import { titleOf } from "../title";
import { TRY_AGAIN } from "../types";
import type { SavedList } from "./saved_list";
import { StudioPart } from "./studio_part";
import "./saved_list";
import "../style/saved.css";

/** The dialog's last message, with the lines below it. */
interface DialogMessage {
	readonly words: string;
	readonly lines: readonly string[];
}

const NO_MESSAGE: DialogMessage = { words: "", lines: [] };

/** The dialog of the saved specimens: saves the current one; lists, opens, renames, deletes, exports and imports saved ones. */
export class SavedDialog extends StudioPart {
	readonly #library = ownLibrary();
	#isOpen = false;
	/** The link of the current specimen, and the parts that the link does not hold. */
	#link = "";
	#lost: readonly string[] = [];
	#name = "";
	/** Whether a specimen is being saved. */
	#busy = false;
	#message = NO_MESSAGE;
	#follow: (() => void) | undefined;

	protected override shows({ state: { specimen, shown } }: Studio): readonly unknown[] {
		return this.#isOpen ? [specimen, shown] : [];
	}

	override connectedCallback(): void {
		super.connectedCallback();
		this.#follow = this.#library.subscribe(() => this.requestUpdate());
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#follow?.();
	}

	protected override draw(studio: Studio): unknown {
		return html`<dialog class="help many saved" aria-labelledby=${this.idOf("title")} @close=${this.#closed} @keydown=${this.#key}>
			<h2 id=${this.idOf("title")}>Saved</h2>
			${this.#isOpen ? this.#body(studio) : nothing}
		</dialog>`;
	}

	/** Opens the dialog; the browser traps the focus and restores it. */
	async open(): Promise<void> {
		if (this.#isOpen) return;
		const { model, specimen } = this.context.state;
		this.#isOpen = true;
		this.#message = NO_MESSAGE;
		this.#lost = notInLink(model, specimen);
		this.#link = await encodeLink(model, specimen);
		this.#suggest();
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
		this.querySelector<HTMLInputElement>(".save input")?.select();
		const suggested = this.#name;
		await this.#library.read();
		if (this.#name === suggested) this.#suggest();
	}

	/** Imports the specimens of a library's file, and shows the result. */
	bring(file: string, document: unknown): Promise<void> {
		return this.#take(file, async () => readLibrary(document));
	}

	#body(studio: Studio): TemplateResult {
		const { all, lastStep } = this.#library;
		const twin = all.find(({ link }) => link === this.#link);
		return html`${this.#form(studio)}
			<div class="said">
				<div role="status">
					<p>${this.#message.words || (twin ? `This ${studio.state.model.noun} is saved already, as “${twin.name}”.` : nothing)}</p>
					${this.#message.lines.length > 0 ? html`<ul>${this.#message.lines.map((line) => html`<li>${line}</li>`)}</ul>` : nothing}
				</div>
				${
					lastStep
						? html`<button class="button" type="button" title="Ctrl+Z" @click=${this.#undo}>${undoLabel(lastStep)}</button>`
						: nothing
				}
			</div>
			${this.#trouble()}
			${all.length > 0 ? this.#list(studio) : emptiness(studio)}
			<p class="where">Kept in this browser only; nothing is sent anywhere. Who clears the browser’s data deletes it too: export it now and then.</p>
			<div class="choices">
				<button class="button" type="button" ?disabled=${all.length === 0} @click=${() => this.#export(all)}>Export all</button>
				${chooseFile({ accept: ".json,application/json", label: "File to import", words: "Import…", take: (file) => void this.#import(file) })}
				<button class="button quiet" type="button" @click=${this.#close}>Close</button>
			</div>`;
	}

	#form({ state: { model, shown } }: Studio): TemplateResult {
		return html`<form class="save" @submit=${this.#save}>
				<label>Name <input
					name="name" required autocomplete="off" maxlength=${LONGEST_NAME} .value=${this.#name}
					@input=${({ target }: Event) => {
						this.#name = (target as HTMLInputElement).value;
					}}
				></label>
				<button class="button wine" ?disabled=${this.#busy || !shown}>Save this ${model.noun}</button>
			</form>
			${this.#lost.length > 0 ? html`<p class="lost">${this.#lost.join(" ")}</p>` : nothing}`;
	}

	/** Warns of specimens that could not be stored, with buttons to export them or try again. */
	#trouble(): unknown {
		const { trouble, unstored } = this.#library;
		if (!trouble && unstored.length === 0) return nothing;
		const count = unstored.length === 1 ? `“${unstored[0].name}” is` : `${unstored.length} are`;
		return html`<div class="trouble" role="alert">
			<p>${trouble ?? nothing} ${unstored.length > 0 ? html`<b>${count} here only until the page is closed:</b> export what you want to keep, or make room and try again.` : nothing}</p>
			${
				unstored.length > 0
					? html`<button class="button" type="button" @click=${() => this.#export(unstored)}>Export what is not kept</button>
						<button class="button" type="button" @click=${() => this.#library.keep()}>Try again</button>`
					: nothing
			}
		</div>`;
	}

	#list(studio: Studio): TemplateResult {
		return html`<panicle-saved-list
			.context=${studio} .library=${this.#library}
			@open-saved=${({ detail }: CustomEvent<Saved>) => void this.#openOne(detail)}
			@message=${({ detail }: CustomEvent<string>) => this.#showMessage({ words: detail })}
		></panicle-saved-list>`;
	}

	#suggest(): void {
		const { specimen, model, modelUi } = this.context.state;
		const names = this.#library.all.map(({ name }) => name);
		this.#name = uniqueName(titleOf(specimen, model, modelUi?.tools), names);
		this.requestUpdate();
	}

	#showMessage(message: Partial<DialogMessage>): void {
		this.#message = { ...NO_MESSAGE, ...message };
		this.requestUpdate();
	}

	async #save(event: SubmitEvent): Promise<void> {
		event.preventDefault();
		if (this.#busy) return;
		this.#busy = true;
		this.#showMessage(NO_MESSAGE);
		try {
			const requestedName = tidyName(this.#name) || titleOf(this.context.state.specimen, this.context.state.model);
			const added = await this.#library.add(await savedOf(this.context, requestedName));
			if (this.#library.isStored(added)) await this.#reportSaved(added, requestedName);
			this.#suggest();
		} catch (error) {
			this.#showMessage({ words: `It was not saved: ${error instanceof Error ? error.message : error}` });
		} finally {
			this.#busy = false;
			this.requestUpdate();
		}
	}

	async #reportSaved({ name }: Saved, requestedName: string): Promise<void> {
		const why = name === requestedName ? "" : `: there is a “${requestedName}” already`;
		this.#showMessage({ words: `Saved as “${name}”${why}.` });
		await requestPersistence();
	}

	async #openOne(saved: Saved): Promise<void> {
		const opening = openSaved(this.context, saved);
		this.#close();
		try {
			await opening;
		} catch {
			const again = () => void this.#openOne(saved);
			this.context.notify(`“${saved.name}” was not opened`, ["Part of the page could not be fetched.", TRY_AGAIN], {
				again,
			});
		}
	}

	readonly #undo = async (): Promise<void> => {
		const step = await this.#library.undo();
		if (!step) return;
		this.#showMessage({ words: undoneInWords(step) });
		this.#suggest();
		await this.updateComplete;
		const list = this.querySelector<SavedList>("panicle-saved-list");
		await list?.updateComplete;
		if (step.kind === "deletion") await list?.goToFirst(step.specimens.map(({ id }) => id));
		else this.querySelector<HTMLElement>(".choices .button")?.focus();
	};

	async #export(several: readonly Saved[]): Promise<void> {
		const saved = await this.#library.withPictures(several);
		const now = Date.now();
		saveFile(writeLibrary(saved, now), `saved-${new Date(now).toISOString().slice(0, 10)}.panicle.json`);
	}

	#import(file: File): Promise<void> {
		return this.#take(file.name, async () => {
			const reader = await import("../../formats/restore");
			const found = await reader.foundInFile(file.name, file);
			if ("library" in found) return readLibrary(found.library);
			throw new reader.FileError(`${file.name} is one plant: Open… opens it.`);
		});
	}

	async #take(file: string, read: () => Promise<Brought>): Promise<void> {
		try {
			const brought = await read();
			this.#showMessage(broughtInWords(brought, await this.#library.bring(brought.saved)));
			this.#suggest();
		} catch (error) {
			this.#showMessage({
				words: `${file} was not imported.`,
				lines: [error instanceof Error ? error.message : String(error)],
			});
		}
	}

	/** Ctrl+Z undoes the library's last step, not the document's; text fields handle the key themselves. */
	#key(event: KeyboardEvent): void {
		if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
		if (event.target instanceof HTMLInputElement && event.target.type !== "checkbox") return;
		event.preventDefault();
		void this.#undo();
	}

	#close(): void {
		this.querySelector("dialog")?.close();
	}

	#closed(): void {
		this.#isOpen = false;
		this.requestUpdate();
	}
}

/** The label of the undo button. */
function undoLabel({ kind, specimens }: LibraryStep): string {
	if (kind === "import") return `Undo the import of ${formatCount(specimens.length)}`;
	return specimens.length === 1 ? `Bring “${specimens[0].name}” back` : `Bring ${formatCount(specimens.length)} back`;
}

function undoneInWords({ kind, specimens }: LibraryStep): string {
	const count = formatCount(specimens.length);
	if (kind === "import") return `The import is undone: ${count} removed.`;
	return specimens.length === 1 ? `“${specimens[0].name}” is back.` : `${count} are back.`;
}

function emptiness({ state: { model } }: Studio): TemplateResult {
	return html`<p class="empty">
		Nothing is saved yet. Here you keep the plants you want to come back to: each under its name, with a picture and its link.
		Save the ${model.noun} on screen, or import what you have exported elsewhere.
	</p>`;
}

customElements.define("panicle-saved", SavedDialog);
