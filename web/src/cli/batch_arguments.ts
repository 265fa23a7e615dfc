/** The options for a series of plants in place of one. */
import { UsageError } from "./usage";

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
 * Undefined for a single plant.
 * @throws UsageError
 */
export function readBatch(values: Values): BatchCall | undefined {
	const { seeds, vary, shard, as = ["glb"], seed, out } = values;
	if (!seeds) {
		const alone = (["vary", "shard", "as", "literal-seeds"] as const).find((option) => values[option]);
		if (alone) throw new UsageError(`--${alone} needs a series; add --seeds, as in --seeds 1-100`);
		return undefined;
	}
	if (seed) throw new UsageError("--seed and --seeds: write one of them");
	if (!out) throw new UsageError("--seeds needs a folder for the files: --out DIR");
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
