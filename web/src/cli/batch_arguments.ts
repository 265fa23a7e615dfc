/** The options for a series of plants in place of one. */
import { text } from "./messages.generated";
import { optionError, UsageError } from "./usage";

export const BATCH_OPTIONS = {
	seeds: { type: "string", multiple: true },
	vary: { type: "string", multiple: true },
	shard: { type: "string", multiple: true },
	as: { type: "string", multiple: true },
	"literal-seeds": { type: "boolean" },
} as const;

/** A series, still unread. */
export interface BatchCall {
	/** Numbers of the plants. */
	seeds: string;
	/** Whether these are the plants' seeds themselves. */
	literal: boolean;
	/** Varied parameters; undefined: only the seed. */
	vary: string | undefined;
	/** The part to grow; undefined: all. */
	shard: string | undefined;
	/** The keys of kinds of files. */
	formats: readonly string[];
}

type Values = Readonly<
	Partial<Record<"seeds" | "vary" | "shard" | "as" | "seed" | "out", string[]> & Record<"literal-seeds", boolean>>
>;

/**
 * Reads the options of a series; undefined for a single plant.
 * @throws UsageError
 */
export function readBatch(values: Values): BatchCall | undefined {
	const { seeds, vary, shard, as = ["glb"], seed, out } = values;
	if (!seeds) {
		const alone = (["vary", "shard", "as", "literal-seeds"] as const).find((option) => values[option]);
		if (alone) throw optionError(`--${alone}`, text.message("only_series"));
		return undefined;
	}
	if (seed) throw new UsageError(text.message("seed_and_seeds"));
	if (!out) throw optionError("--seeds", text.message("seeds_need_folder"));
	return {
		seeds: seeds.join(),
		literal: values["literal-seeds"] ?? false,
		vary: vary?.join(),
		shard: shard?.at(-1),
		formats: as
			.join()
			.split(",")
			.map((format) => format.trim()),
	};
}
