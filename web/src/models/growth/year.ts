/** The year of a tree: maps the season's slider to colours of leaves. */

/**
 * Positions on the slider at which the first buds open, summer is, leaves begin to turn and all have turned
 * (wasm-core/src/models/growth/foliage.cpp).
 */
const [BUDS, SUMMER, TURNING, TURNED] = [0.12, 0.4, 0.52, 0.78];

/**
 * Returns the season for leaf colours (plant/leaf_colours.ts): 0 spring, 0.4 summer, 1 autumn.
 * @param season of the slider, 0 late winter … 1 winter
 */
export function leafSeason(season: number, evergreen: boolean): number {
	if (evergreen) return SUMMER;
	if (season < SUMMER) return SUMMER * Math.max(0, (season - BUDS) / (SUMMER - BUDS));
	return SUMMER + (1 - SUMMER) * Math.min(1, Math.max(0, (season - TURNING) / (TURNED - TURNING)));
}
