/** The page Search. */
import '../element/hex-lens'
