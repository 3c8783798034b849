# The headers of the C API for doxygen: their comments in doxygen's notation. Headings aren't anybody's.
1s|^/\* |/** @file\n|
/^\/\* ---- .* ---- \*\/$/d
s|^\( *\)/\* |\1/** |
s|\([;,{0-9A-Z]\) */\* |\1 /**< |
