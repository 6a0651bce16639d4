/** The page Challenges. */
import '../element/hex-lens'
