/** The earliest date of ZIP archives, in local time, so that the same plant gives the same archive. */
export const ZIP_DATE = new Date(1980, 0, 1);
