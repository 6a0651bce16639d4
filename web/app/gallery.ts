/** The page Gallery. */
import '../element/hex-lens'
