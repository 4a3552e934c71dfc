(* Generated from coq/Extraction.v by "make -C coq extract": do not edit. *)

val xorb : bool -> bool -> bool

val negb : bool -> bool

type nat =
| O
| S of nat

val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2

val length : 'a1 list -> nat

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val compOpp : comparison -> comparison

val add : nat -> nat -> nat

val mul : nat -> nat -> nat

type positive =
| XI of positive
| XO of positive
| XH

type z =
| Z0
| Zpos of positive
| Zneg of positive

val eqb : bool -> bool -> bool

module Nat :
 sig
  val eqb : nat -> nat -> bool

  val leb : nat -> nat -> bool

  val ltb : nat -> nat -> bool
 end

module Pos :
 sig
  val succ : positive -> positive

  val add : positive -> positive -> positive

  val add_carry : positive -> positive -> positive

  val pred_double : positive -> positive

  val mul : positive -> positive -> positive

  val iter : ('a1 -> 'a1) -> 'a1 -> positive -> 'a1

  val compare_cont : comparison -> positive -> positive -> comparison

  val compare : positive -> positive -> comparison

  val eqb : positive -> positive -> bool

  val iter_op : ('a1 -> 'a1 -> 'a1) -> positive -> 'a1 -> 'a1

  val to_nat : positive -> nat

  val of_succ_nat : nat -> positive
 end

module Z :
 sig
  val double : z -> z

  val succ_double : z -> z

  val pred_double : z -> z

  val pos_sub : positive -> positive -> z

  val add : z -> z -> z

  val opp : z -> z

  val sub : z -> z -> z

  val mul : z -> z -> z

  val pow_pos : z -> positive -> z

  val pow : z -> z -> z

  val compare : z -> z -> comparison

  val leb : z -> z -> bool

  val ltb : z -> z -> bool

  val eqb : z -> z -> bool

  val max : z -> z -> z

  val min : z -> z -> z

  val to_nat : z -> nat

  val of_nat : nat -> z

  val pos_div_eucl : positive -> z -> z * z

  val div_eucl : z -> z -> z * z

  val div : z -> z -> z

  val even : z -> bool
 end

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

val list_prod : 'a1 list -> 'a2 list -> ('a1 * 'a2) list

val seq : nat -> nat -> nat list

type coord3 =
| C3 of z * z * z

val translate : coord3 -> coord3 -> coord3

val scale : z -> coord3 -> coord3

val difference : coord3 -> coord3 -> coord3

val coord3Equal : coord3 -> coord3 -> bool

type direction =
| Dir_p00
| Dir_m00
| Dir_0p0
| Dir_0m0
| Dir_00p
| Dir_00m
| Dir_ppp
| Dir_mmm
| Dir_ppm
| Dir_mmp
| Dir_pmp
| Dir_mpm
| Dir_mpp
| Dir_pmm

val allDirections : direction list

val offset : direction -> coord3

type edgeKind =
| Long
| Short

val directionKind : direction -> edgeKind

val lengthSquared : edgeKind -> z

type structuredTetCase =
| Tet_I1
| Tet_I2
| Tet_I3
| Tet_I4
| Tet_J1
| Tet_J2
| Tet_J3
| Tet_J4
| Tet_K1
| Tet_K2
| Tet_K3
| Tet_K4

type structuredTetId =
| STId of coord3 * structuredTetCase

type vertexOrder =
  coord3 -> coord3 -> coord3 -> coord3 ->
  ((coord3 * coord3) * coord3) * coord3

type structuredTet =
| ST of coord3 * coord3 * coord3 * coord3 * (structuredTetId * vertexOrder)
   * (structuredTetId * vertexOrder) * (structuredTetId * vertexOrder)
   * (structuredTetId * vertexOrder)

val order1234 : vertexOrder

val order2143 : vertexOrder

type handedness =
| RightHanded
| LeftHanded

val caseHandedness : structuredTetCase -> handedness

val getStructuredTet : structuredTetId -> structuredTet

val allCases : structuredTetCase list

type place =
| First
| Second
| Third
| Fourth

type sign =
| Plus
| OnSurface
| Minus

type 'vertex unstructuredTet =
| UT of 'vertex * 'vertex * 'vertex * 'vertex

val getUnstructuredTets :
  ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
  unstructuredTet list

val mapTet : ('a1 -> 'a2) -> 'a1 unstructuredTet -> 'a2 unstructuredTet

val stepBits : nat

val steps : z

val bisectFrom : (z -> sign) -> nat -> z -> z

val bisect : (z -> sign) -> z

val midpointCut : z

val inOrOut : sign -> sign

val pointOnEdge : coord3 -> coord3 -> z -> coord3

type thresholds =
| TH of z * z

val angleThresholds : thresholds

val embeddingThresholds : thresholds

val noWarpThresholds : thresholds

val thresholdSteps : thresholds -> edgeKind -> z

type warping =
| Stays
| Moves of direction * z

val opposite : sign -> sign -> bool

val violates :
  thresholds -> sign -> (direction -> sign) -> (direction -> z) -> direction
  -> bool

val cutDistanceSquared : (direction -> z) -> direction -> z

val nearerOf :
  thresholds -> sign -> (direction -> sign) -> (direction -> z) -> warping ->
  direction -> warping

val warp :
  thresholds -> sign -> (direction -> sign) -> (direction -> z) -> warping

val warpedSign : sign -> warping -> sign

val warpedPosition : coord3 -> warping -> coord3

type signField = coord3 -> sign

type cutField = coord3 -> coord3 -> z

type meshVertex =
| Corner of coord3
| Cut of coord3 * coord3

val cutFrom : signField -> cutField -> coord3 -> direction -> z

val warpVertex : thresholds -> signField -> cutField -> coord3 -> warping

val meshVertexSign : thresholds -> signField -> cutField -> meshVertex -> sign

val meshIntersection : meshVertex -> meshVertex -> meshVertex

val meshPosition : thresholds -> signField -> cutField -> meshVertex -> coord3

val orient :
  handedness -> meshVertex unstructuredTet -> meshVertex unstructuredTet

val stuffTet :
  thresholds -> signField -> cutField -> structuredTetId -> meshVertex
  unstructuredTet list

type positionSigns = coord3 -> sign

val sampledSigns : positionSigns -> signField

val bisectedCuts : positionSigns -> cutField

val midpointCuts : cutField

val decided : signField -> signField

val dot : coord3 -> coord3 -> z

val cross : coord3 -> coord3 -> coord3

val normal : coord3 -> coord3 -> coord3 -> coord3

val sixVolume : coord3 -> coord3 -> coord3 -> coord3 -> z

val edgeSquared : coord3 -> coord3 -> z

val normalsProduct : coord3 -> coord3 -> coord3 -> coord3 -> z

type cotSquared =
| CotSq of z * z

val dihedralEdges : 'a1 unstructuredTet -> ((('a1 * 'a1) * 'a1) * 'a1) list

type angleBounds =
| AB of cotSquared * cotSquared

val corners : structuredTetId -> coord3 list

val placedSign : signField -> (coord3 -> warping) -> meshVertex -> sign

val placedPosition : (coord3 -> warping) -> cutField -> meshVertex -> coord3

val placedTets :
  signField -> (coord3 -> warping) -> cutField -> structuredTetId -> coord3
  unstructuredTet list

val widestAngles : angleBounds

val placedNames :
  signField -> (coord3 -> warping) -> structuredTetId -> meshVertex
  unstructuredTet list

val kindBetween : coord3 -> coord3 -> edgeKind

val clampedCut : thresholds -> cutField -> coord3 -> coord3 -> z

val sameDirection : direction -> direction -> bool

val nextInLink : direction -> direction -> bool

val flood : nat -> (direction -> bool) -> direction list -> direction list

val onePiece : (direction -> bool) -> bool

val isInner : (direction -> sign) -> direction -> bool

val isZero : (direction -> sign) -> direction -> bool

val violated : thresholds -> signField -> cutField -> coord3 -> bool

val colour : coord3 -> nat

val turn : thresholds -> signField -> cutField -> coord3 -> nat

val turns : nat

module PositiveMap :
 sig
  type key = positive

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val find : key -> 'a1 t -> 'a1 option

  val add : key -> 'a1 -> 'a1 t -> 'a1 t
 end

type 'a link =
| L14 of 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a * 'a

val gather : (direction -> 'a1) -> 'a1 link

val at : 'a1 link -> direction -> 'a1

val neighborTable : direction list link

val ringTable : (direction * direction) list link

val wallTable : ((direction * direction) * (direction * direction)) list

val spread : bool link -> bool link -> bool link

val spreadFor : nat -> bool link -> bool link -> bool link

val inOnePiece : bool link -> bool

val twoPieces : bool link -> bool

val pinched : bool link -> direction -> bool

val walls : bool link -> (direction * direction) list

val diskOf : bool link -> bool link -> bool

val isDisk : sign link -> bool

val openSigns : signField -> signField

val openCuts : signField -> cutField -> cutField

val spelled : positive -> positive -> positive

val positiveOf : z -> positive

val pointKey : coord3 -> positive

type zeros = warping PositiveMap.t

val noZeros : zeros

val placeIn : zeros -> coord3 -> warping

type gap = sign -> sign -> z

val levelGap : gap

val strictGap : gap

val towards : direction -> direction -> bool

val roomFor : signField -> gap -> coord3 -> coord3 -> z

val roomBeside :
  signField -> gap -> (coord3 -> warping) -> (coord3 -> nat) -> zeros ->
  coord3 -> direction -> z -> direction -> z

val shortened :
  signField -> gap -> (coord3 -> warping) -> (coord3 -> nat) -> zeros ->
  coord3 -> direction -> z -> z

val staysRather :
  thresholds -> (direction -> bool) -> direction -> z -> z -> bool

val signAmong : signField -> zeros -> coord3 -> sign

val linkAmong : signField -> zeros -> coord3 -> sign link

val violatesAt :
  thresholds -> signField -> cutField -> coord3 -> direction -> bool

val settleOne :
  thresholds -> signField -> cutField -> gap -> zeros -> coord3 -> zeros

val settle :
  thresholds -> signField -> cutField -> gap -> coord3 list -> zeros

val inTurn : thresholds -> signField -> cutField -> coord3 list -> coord3 list

val settledTets :
  thresholds -> signField -> cutField -> zeros -> structuredTetId -> coord3
  unstructuredTet list

val settledMesh :
  thresholds -> signField -> cutField -> gap -> coord3 list ->
  structuredTetId list -> coord3 unstructuredTet list

type voxelGrid =
| Grid of z * coord3 * coord3

val owner : voxelGrid -> coord3 -> coord3

val inImage : voxelGrid -> (coord3 -> bool) -> coord3 -> bool

val cubeInner : voxelGrid -> (coord3 -> bool) -> coord3 -> direction -> bool

val cubeParted : voxelGrid -> (coord3 -> bool) -> coord3 -> bool

val voxelSigns : voxelGrid -> (coord3 -> bool) -> signField

type material = z

val outside : material

val materialFill :
  ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 -> 'a1
  -> (material * 'a1 unstructuredTet) list

val signAmongMaterials : ('a1 -> material option) -> material -> 'a1 -> sign

val materialCut :
  ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1

val addMaterial :
  ('a1 -> material option) -> material list -> 'a1 -> material list

val materialsOf : ('a1 -> material option) -> 'a1 list -> material list

val tetsOfOne :
  ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 -> 'a1
  -> material -> (material * 'a1 unstructuredTet) list

val getMaterialTets :
  ('a1 -> material option) -> ('a1 -> 'a1 -> 'a1) -> 'a1 -> 'a1 -> 'a1 -> 'a1
  -> material -> (material * 'a1 unstructuredTet) list

type materialField = coord3 -> material option

val vertexMaterial : materialField -> meshVertex -> material option

val orientMaterialTet :
  handedness -> (material * meshVertex unstructuredTet) ->
  material * meshVertex unstructuredTet

val materialNames :
  materialField -> (structuredTetId -> material) -> structuredTetId ->
  (material * meshVertex unstructuredTet) list

val materialCutFrom : materialField -> cutField -> coord3 -> direction -> z

val warpMaterialVertex :
  thresholds -> materialField -> cutField -> coord3 -> warping

val placedMaterial :
  materialField -> (coord3 -> warping) -> coord3 -> material option

val placedMaterialTets :
  materialField -> (coord3 -> warping) -> cutField -> (structuredTetId ->
  material) -> structuredTetId -> (material * coord3 unstructuredTet) list

val placedWhole :
  (coord3 -> warping) -> cutField -> structuredTetId -> coord3 unstructuredTet

type cellSet = nat -> coord3 -> bool

val halfSide : nat -> z

val centreInHalfSides : coord3 -> coord3

val parentCell : coord3 -> coord3

val hasChild : cellSet -> nat -> coord3 -> bool

val unitCube : coord3 list

val isUsed : cellSet -> nat -> coord3 -> bool

type axisOrder =
| XYZ
| XZY
| YXZ
| YZX
| ZXY
| ZYX

val arrange : axisOrder -> z -> z -> z -> coord3

val alongFirst : axisOrder -> coord3 -> z

val swapLast : axisOrder -> axisOrder

val swapFirst : axisOrder -> axisOrder

val rotateIn : axisOrder -> axisOrder

val rotateOut : axisOrder -> axisOrder

type flag =
| MakeFlag of nat * coord3 * axisOrder * bool * bool * bool

val levelOf : flag -> nat

val cellOf : flag -> coord3

val signed : bool -> z -> z

val stepFrom : flag -> z -> z -> z -> coord3

val pointInHalfSides : flag -> z -> z -> z -> coord3

val pointSeen : flag -> z -> z -> z -> coord3

val cellSeen : flag -> z -> z -> z -> coord3

val childAlong : bool -> z -> z

val childSeen : flag -> z -> z -> z -> coord3

val isAhead : bool -> z -> bool

val aheadAtFace : flag -> bool

val aheadAtEdge : flag -> bool

val aheadAtCorner : flag -> bool

val otherCorner : flag -> flag

val otherEdge : flag -> flag

val otherFace : flag -> flag

val otherCell : flag -> flag

val finerInCell : flag -> flag

val finerInOther : flag -> flag

val coarser : flag -> flag

type gradedKind =
| BccTet
| EdgeHalfTet
| FaceHalfTet
| QuarterTet
| PyramidTet

type gradedTetId =
| GTId of gradedKind * flag

val isPresent : cellSet -> flag -> bool

val kindAt : cellSet -> flag -> gradedKind

val withLowerCell : flag -> flag

val withUpperCorner : flag -> flag

val isOffDiagonal : flag -> bool

val withCornerOffDiagonal : flag -> flag

val namingFlag : gradedKind -> flag -> flag

val tetOfFlag : cellSet -> flag -> gradedTetId

val flagsOf : gradedTetId -> flag list

val isUpperEdge : flag -> bool

val gradedVertices : gradedTetId -> ((coord3 * coord3) * coord3) * coord3

val isEvenOrder : axisOrder -> bool

val gradedHandedness : gradedTetId -> handedness

val getGradedTet : gradedTetId -> coord3 unstructuredTet

val flagAtFace : gradedTetId -> place -> flag * place

val flagAcross : cellSet -> flag -> place -> flag

val gradedNeighbor : cellSet -> gradedTetId -> place -> gradedTetId

val edgeRank : coord3 -> coord3 -> z

val mirrored : handedness -> handedness

val handed : handedness -> 'a1 unstructuredTet -> 'a1 unstructuredTet

val before : ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> bool

val pyramidInOrder :
  ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
  unstructuredTet list

val pyramid :
  ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 -> 'a1
  -> 'a1 -> 'a1 unstructuredTet list

val prismInOrder :
  ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
  unstructuredTet list

val prism :
  ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 -> 'a1
  -> 'a1 -> 'a1 unstructuredTet list

val wedgeAcross :
  ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
  unstructuredTet list

val wedgeBeside :
  ('a1 -> 'a1 -> 'a1) -> handedness -> 'a1 -> 'a1 -> 'a1 -> 'a1 -> 'a1
  unstructuredTet list

val wedgeTowards :
  ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 -> 'a1
  -> 'a1 -> 'a1 unstructuredTet list

val wedge :
  ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> handedness -> 'a1 -> 'a1 -> 'a1
  -> 'a1 -> 'a1 unstructuredTet list

val getKeyTets :
  ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 ->
  'a1 -> 'a1 -> 'a1 unstructuredTet list

type 'vertex triangle = ('vertex * 'vertex) * 'vertex

val halves :
  ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 -> 'a1 -> 'a1
  triangle list

val faceTriangles :
  ('a1 -> sign) -> ('a1 -> 'a1 -> 'a1) -> ('a1 -> 'a1 -> z) -> 'a1 -> 'a1 ->
  'a1 -> 'a1 triangle list

val cutKey : cutField -> coord3 -> coord3 -> z

val meshKey : (coord3 -> coord3 -> z) -> meshVertex -> meshVertex -> z

val keyThresholds : thresholds

val orderedNames :
  (coord3 -> coord3 -> z) -> signField -> (coord3 -> warping) ->
  structuredTetId -> meshVertex unstructuredTet list

val keyNames :
  signField -> (coord3 -> warping) -> cutField -> structuredTetId ->
  meshVertex unstructuredTet list

val keyTets :
  signField -> (coord3 -> warping) -> cutField -> structuredTetId -> coord3
  unstructuredTet list

val keyStuffTet :
  thresholds -> signField -> cutField -> structuredTetId -> meshVertex
  unstructuredTet list

type mesh = { tetsWithin : (structuredTetId -> meshVertex unstructuredTet
                           list); signIn : (meshVertex -> sign);
              positionIn : (meshVertex -> coord3) }

val pointsOfCell : coord3 -> coord3 list

val isPlus : sign -> bool

val isNearSurface : signField -> coord3 -> bool

val aroundChildren : coord3 list

val closedCells : cellSet -> nat -> coord3 -> bool

val octreeAround : cellSet -> nat -> cellSet

val gradedOctree : signField -> nat -> cellSet

val structuredOf : flag -> structuredTetId

val structuredName : gradedTetId -> structuredTetId option

val gradedTetsWithin : mesh -> gradedTetId -> meshVertex unstructuredTet list

val isAngleWithin :
  angleBounds -> coord3 -> coord3 -> coord3 -> coord3 -> bool

val isWellShaped : angleBounds -> coord3 unstructuredTet -> bool

val cornerOffsets : z list

val anchors : coord3 -> coord3 list

val tetsAround : coord3 -> structuredTetId list

val signsAmong : (material -> bool) -> material option link -> sign link

val lowestOf : material list -> material

val areDisks : material list -> material option link -> bool

val fillsWouldTouch : material option link -> bool

val lowerOf : (coord3 -> material) -> coord3 -> direction -> material

val isHigher : (coord3 -> material) -> coord3 -> direction -> bool

val materialSide : thresholds -> (coord3 -> material) -> cutField -> signField

val materialLink :
  (coord3 -> material) -> zeros -> coord3 -> material option link

val materialsAround :
  (coord3 -> material) -> coord3 -> direction -> material option link ->
  material list

val lowerIn : (coord3 -> material) -> zeros -> coord3 -> material option

val sharedIn : (coord3 -> material) -> zeros -> structuredTetId -> material

val haveMoved : zeros -> structuredTetId -> bool

val isLowestAt : (coord3 -> material) -> material -> coord3 -> bool

val mayShare :
  angleBounds -> (coord3 -> material) -> cutField -> zeros -> structuredTetId
  -> bool

val materialViolatesAt :
  thresholds -> (coord3 -> material) -> cutField -> coord3 -> direction ->
  bool

val materialTurn :
  thresholds -> (coord3 -> material) -> cutField -> coord3 -> nat

val settleOneMaterial :
  angleBounds -> thresholds -> (coord3 -> material) -> cutField -> zeros ->
  coord3 -> zeros

val settleMaterials :
  angleBounds -> thresholds -> (coord3 -> material) -> cutField -> coord3
  list -> zeros

val materialsInTurn :
  thresholds -> (coord3 -> material) -> cutField -> coord3 list -> coord3 list

val settledMaterialTets :
  thresholds -> (coord3 -> material) -> cutField -> zeros -> structuredTetId
  -> (material * coord3 unstructuredTet) list
