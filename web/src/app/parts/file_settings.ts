/** Options of a file, beside its button in the download sheet. */
import { html, nothing } from "lit";
import { NUMERIC_FILE_OPTIONS } from "../../formats/file_options";
import { LOW_TRIANGLES, POINTS, THICKNESS, WIND_TRIANGLES } from "../../formats/plant_files";
import type { DownloadFormat, DownloadOptions } from "../files/formats";
import { text } from "../messages.generated";

interface NumberField {
	readonly least: number;
	readonly most: number;
	readonly step: number;
	label(): string;
	/** The value without a choice; undefined where an empty field means the default. */
	preset?(format: string): number;
}

const NUMBERS: Partial<Record<keyof DownloadOptions, NumberField>> = {
	triangles: {
		...NUMERIC_FILE_OPTIONS.triangles,
		step: 1,
		label: () => text("options_triangles"),
		preset: (format) => (format === "glb-wind" ? WIND_TRIANGLES : LOW_TRIANGLES),
	},
	thickness: {
		...NUMERIC_FILE_OPTIONS.thickness,
		step: 0.1,
		label: () => text("options_thickness"),
		preset: () => THICKNESS,
	},
	points: { ...NUMERIC_FILE_OPTIONS.points, step: 1, label: () => text("options_points"), preset: () => POINTS },
	height: { least: 16, most: 8192, step: 1, label: () => text("options_height") },
};

const SWITCHES: Partial<Record<keyof DownloadOptions, () => string>> = {
	translucent: () => text("options_translucent"),
	textures: () => text("options_textures"),
	windColours: () => text("options_wind_colours"),
};

/**
 * Renders the fields of the options that a format uses; nothing without any.
 * @param changed called with all options of the format after a valid change
 */
export function fileSettings(
	{ key, title, uses = [] }: DownloadFormat,
	options: DownloadOptions,
	changed: (options: DownloadOptions) => void,
): unknown {
	if (uses.length === 0) return nothing;
	return html`<fieldset class="file-settings" aria-label=${text("options_of", { file: title })}>
		${uses.map((option) => optionField(option, key, options, changed))}
	</fieldset>`;
}

/**
 * Renders the field of an option: a checkbox or a number.
 * @param format key of the format, on which defaults depend
 * @param changed receives all options of the format after a valid change
 */
function optionField(
	option: keyof DownloadOptions,
	format: string,
	options: DownloadOptions,
	changed: (options: DownloadOptions) => void,
): unknown {
	const label = SWITCHES[option];
	if (label) {
		const check = ({ target }: Event) => changed({ ...options, [option]: (target as HTMLInputElement).checked });
		return html`<label class="toggle"><input type="checkbox" .checked=${options[option] === true} @change=${check}> ${label()}</label>`;
	}
	const number = NUMBERS[option];
	if (!number) return nothing;
	const preset = number.preset?.(format);
	const type = ({ target }: Event) => {
		const input = target as HTMLInputElement;
		// The browser reports invalid numbers.
		if (!input.reportValidity()) return;
		const { [option]: _, ...others } = options;
		// An empty field means the default.
		changed(input.value === "" ? others : { ...options, [option]: input.valueAsNumber });
	};
	return html`<label>${number.label()} <input
		type="number" ?required=${preset !== undefined} min=${number.least} max=${number.most} step=${number.step}
		placeholder=${preset === undefined ? text("options_height_default") : nothing}
		.value=${String(options[option] ?? preset ?? "")} @change=${type}
	></label>`;
}
