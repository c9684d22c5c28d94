#!/bin/sh
# A header as Doxygen is to read it. The plain comment at its top becomes the description of the file; in
# error.h the table of error codes stands in the place of its inclusion, each code with its text, exit
# code and remedy.
table=cpp/include/girth/error_codes.def
code='GIRTH_ERROR_CODE(\([A-Za-z]*\), "\([A-Z_]*\)", \([0-9]\), "\(.*\)")'
sed -e "/#include \"girth\/error_codes.def\"/r $table" "$1" |
  sed -e '1s#^// .*#& @file#' \
    -e '1,/^#pragma/s#^//\( \|$\)#///\1#' \
    -e '/^#define GIRTH_ERROR_CODE\|^#undef GIRTH_ERROR_CODE\|error_codes.def"$/d' \
    -e "s#^$code#\1, ///< \2, exit code \3: \4.#"
