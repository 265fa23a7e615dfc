import { shortFloat } from "./numbers";

/**
 * Returns a value for JSON with every float32 in it as the shortest decimal that reads back as the same; other numbers
 * as they are.
 */
export function written(value: unknown): unknown {
	if (typeof value === "number") return Math.fround(value) === value ? shortFloat(value) : value;
	if (Array.isArray(value)) return value.map(written);
	if (typeof value !== "object" || value === null) return value;
	return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, written(each)]));
}
