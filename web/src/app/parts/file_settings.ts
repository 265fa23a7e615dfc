/** Settings for files, in the download menu. */
import { html } from "lit";
import { NUMERIC_FILE_OPTIONS } from "../../formats/file_options";
import { LOW_TRIANGLES, THICKNESS } from "../../formats/plant_files";
import type { DownloadRequest } from "../files/formats";

type Options = DownloadRequest["options"];

/** @param changed called with all options after a valid change */
export function fileSettings(options: Options, changed: (options: Options) => void): unknown {
	const number = ({ target }: Event) => {
		const field = target as HTMLInputElement;
		// The browser reports invalid numbers.
		if (!field.reportValidity()) return;
		const { [field.name as keyof Options]: _, ...others } = options;
		// An empty field means the default.
		changed(field.value === "" ? others : { ...options, [field.name]: field.valueAsNumber });
	};
	const check = ({ target }: Event) => {
		const { name, checked } = target as HTMLInputElement;
		changed({ ...options, [name]: checked });
	};
	return html`<fieldset class="file-settings">
		<legend>For these files</legend>
		<label>Triangles, low
			<input type="number" name="triangles" required min=${NUMERIC_FILE_OPTIONS.triangles.least} max=${NUMERIC_FILE_OPTIONS.triangles.most} step="1" .value=${String(options.triangles ?? LOW_TRIANGLES)} @change=${number}>
		</label>
		<label>Least thickness, printers (mm)
			<input type="number" name="thickness" required min=${NUMERIC_FILE_OPTIONS.thickness.least} max=${NUMERIC_FILE_OPTIONS.thickness.most} step="0.1" .value=${String(options.thickness ?? THICKNESS)} @change=${number}>
		</label>
		<label>Picture height (px)
			<input type="number" name="height" min="16" max="8192" step="1" placeholder="as on the page" .value=${String(options.height ?? "")} @change=${number}>
		</label>
		<label>Light through pale flesh
			<input type="checkbox" name="translucent" .checked=${options.translucent ?? false} @change=${check}>
		</label>
		<label>Baked textures, GLB
			<input type="checkbox" name="textures" .checked=${options.textures ?? false} @change=${check}>
		</label>
	</fieldset>`;
}
