/** The earliest date that ZIP archives know, as clocks show it anywhere: the same plant gives the same archive. */
export const ZIP_DATE = new Date(1980, 0, 1);
