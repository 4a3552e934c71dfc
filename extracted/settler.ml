open Certified

type t = {
  thresholds : thresholds;
  lattice : Lattice.t;
  sign : signField;
  cut : cutField;
  zeros : zeros;
}

let settle gap thresholds lattice { Domain.sign = sample; cut } =
  let sign = openSigns sample in
  let cut = openCuts sample cut in
  let order = inTurn thresholds sign cut (Lattice.points lattice) in
  { thresholds; lattice; sign; cut; zeros = settle thresholds sign cut gap order }

let place { zeros; _ } = placeIn zeros

let iter_tets { lattice; sign; zeros; _ } visit =
  Lattice.iter_tets lattice (fun id ->
      List.iter visit (placedNames sign (placeIn zeros) id))

let position { thresholds; cut; zeros; _ } v =
  Convert.point_of_coord3
    (placedPosition (placeIn zeros) (clampedCut thresholds cut) v)

let mesh { thresholds; sign; cut; zeros; _ } =
  {
    tetsWithin = placedNames sign (placeIn zeros);
    signIn = placedSign sign (placeIn zeros);
    positionIn = placedPosition (placeIn zeros) (clampedCut thresholds cut);
  }
