/** A volume's numbers as Table 4 calls them, in its order: N, T, atx, aty, atz, H, L, W, m. */
export const FIELDS = [
	"degree",
	"transl_coef",
	"x_rotation",
	"y_rotation",
	"z_rotation",
	"height",
	"length",
	"width",
	"material",
] as const;
