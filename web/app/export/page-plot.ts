// A plot on the page, as a file.

export interface PagePlot {
  /** Part of the file's name. */
  word: string;
  /** So many millimetres wide; undefined where it is not seen now. */
  svg: (width?: number) => string | undefined;
}
