/** The page Lessons. */
import '../element/hex-lens'
