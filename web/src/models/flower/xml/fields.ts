/** Element names of Table 4 for a volume's numbers, in order: N, T, atx, aty, atz, H, L, W, m. */
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
